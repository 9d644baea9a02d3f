// SPDX-License-Identifier: MIT
// Are bodies, points, unknowns and numbers of a mechanism what they must be? Joints and drivers
// have files of their own.
#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "faults.h"
#include "moivre/mechanism/rules.h"
#include "names.h"

namespace moivre {
namespace {

std::string quoted(const std::string& name) { return "'" + name + "'"; }

void check_body_name(const Body& body, std::size_t index, std::set<std::string_view>& taken,
                     Faults& faults) {
  // Reports escape what a name holds; only a file needs names that can be typed in it.
  if (index == 0 && body.name != "ground") {
    faults.push_back(
        {body.where, "the first body is the ground, and called so, not " + quoted(body.name)});
  }
  if (body.name.empty()) faults.push_back({body.where, "a body has no name"});
  if (!taken.insert(body.name).second) {
    faults.push_back({body.where, "two bodies are called " + quoted(body.name)});
  }
}

void check_points(const Body& body, Space space, Faults& faults) {
  std::set<std::string_view> taken;
  for (const BodyPoint& point : body.points) {
    const auto fault = [&](const char* rule) {
      faults.push_back({point.where, "point " + quoted(body.name + "." + point.name) + rule});
    };
    if (point.name.empty()) fault(": it has no name");
    if (!taken.insert(point.name).second) fault(" is there twice");
    if (!std::all_of(point.at.begin(), point.at.end(), is_workable)) {
      fault(" has a coordinate that is not finite, or beyond 1e50");
    } else if (space == Space::planar && point.at.z() != 0) {
      fault(" of a planar mechanism must have z = 0");
    }
  }
}

void check_bodies(const Mechanism& mechanism, Faults& faults) {
  if (mechanism.bodies.empty()) {
    faults.push_back({{}, "there is no ground: the first body is it"});
    return;
  }
  std::set<std::string_view> taken;
  for (std::size_t k = 0; k < mechanism.bodies.size(); ++k) {
    check_body_name(mechanism.bodies[k], k, taken, faults);
    check_points(mechanism.bodies[k], mechanism.space, faults);
  }
}

void check_unknowns(const Mechanism& mechanism, Faults& faults) {
  std::set<std::string_view> taken;
  for (const Unknown& unknown : mechanism.unknowns) {
    if (unknown.name.empty()) faults.push_back({unknown.where, "an unknown has no name"});
    if (!taken.insert(unknown.name).second) {
      faults.push_back({unknown.where, "two unknowns are called " + quoted(unknown.name)});
    }
  }
  const bool has_bodies = mechanism.bodies.size() > 1 || !mechanism.joints.empty();
  if (is_typed(mechanism) && has_bodies) {
    faults.push_back({{}, "there are bodies and typed unknowns: a mechanism has either"});
  }
  if (!is_typed(mechanism) && !mechanism.equations.empty()) {
    faults.push_back({{}, "there are equations without unknowns"});
  }
  for (const Equation& equation : mechanism.equations) {
    const std::string fault = fault_of(equation.formula, mechanism.unknowns.size());
    if (fault.empty()) continue;
    faults.push_back({equation.where, "equation " + quoted(equation.name) + " " + fault});
  }
}

void check_spins(const Mechanism& mechanism, Faults& faults) {
  const auto is_there = [&](const PointOf& p) {
    return p.body < mechanism.bodies.size() && p.point < mechanism.bodies[p.body].points.size();
  };
  for (const Spin& spin : mechanism.held_spins) {
    const bool is_whole = spin.body > 0 && spin.body < mechanism.bodies.size() &&
                          is_there(spin.line[0]) && is_there(spin.line[1]);
    if (!is_whole) faults.push_back({{}, "a held spin names a body or a point that is not there"});
  }
}

void check_numbers(const Mechanism& mechanism, Faults& faults) {
  const auto check = [&](bool is_right, const std::string& what, const char* rule) {
    if (!is_right) faults.push_back({{}, what + rule});
  };
  for (const auto& [name, value] : mechanism.constants) {
    check(is_workable(value), "constant " + quoted(name), " must be finite, up to 1e50");
  }
  for (const auto& [name, value] : mechanism.guess) {
    check(is_workable(value), "the guess of " + quoted(name), " must be finite, up to 1e50");
  }
  for (const auto& [name, value] : mechanism.tolerances) {
    check(value >= 0 && is_workable(value), "the tolerance of " + quoted(name),
          " must be a finite number from 0");
  }
  const double fit = mechanism.fit.value_or(1);
  check(fit > 0 && is_workable(fit), "fit", " must be a finite length above 0");
  const double tolerance = mechanism.tolerance.value_or(0);
  check(tolerance >= 0 && is_workable(tolerance), "tolerance", " must be a finite length from 0");
}

/// Names of the guess are of coordinates.
void check_guess(const Mechanism& mechanism, Faults& faults) {
  if (mechanism.guess.empty() || !faults.empty()) return;
  std::set<std::string> known;
  for (const Coordinate& coordinate : coordinates(mechanism)) known.insert(coordinate.name);
  for (const auto& [name, value] : mechanism.guess) {
    if (known.count(name) != 0) continue;
    faults.push_back({{}, "the guess names a coordinate that is not there, " + quoted(name)});
  }
}

}  // namespace

std::string fault_of(const Formula& formula, std::size_t unknowns) {
  using Kind = Formula::Kind;
  const Kind kind = formula.kind;
  if (kind == Kind::time) return "";
  if (kind == Kind::constant) {
    return std::isfinite(formula.value) ? "" : "has a constant that is not finite";
  }
  if (kind == Kind::unknown) {
    if (formula.index < unknowns) return "";
    return "has unknown " + std::to_string(formula.index) + ", counted from 0, of " +
           std::to_string(unknowns);
  }
  const std::size_t operands = formula.operands.size();
  if (kind == Kind::power && operands != 2) return "has a power without its two operands";
  const bool takes_one = kind != Kind::power && kind != Kind::sum && kind != Kind::product;
  if (takes_one && operands != 1) return "has a function without its one operand";
  for (const Formula& operand : formula.operands) {
    std::string fault = fault_of(operand, unknowns);
    if (!fault.empty()) return fault;
  }
  return "";
}

void find_form_faults(const Mechanism& mechanism, Faults& faults) {
  check_bodies(mechanism, faults);
  if (mechanism.bodies.empty()) return;
  check_unknowns(mechanism, faults);
  check_spins(mechanism, faults);
  check_numbers(mechanism, faults);
  find_joint_faults(mechanism, faults);
  find_driver_faults(mechanism, faults);
  check_guess(mechanism, faults);
}

namespace {

std::vector<std::string> sentences(const Faults& faults) {
  std::vector<std::string> rules;
  for (const Diagnostic& fault : faults) rules.push_back(fault.message);
  return rules;
}

}  // namespace

std::vector<std::string> broken_form(const Mechanism& mechanism) {
  Faults faults;
  find_form_faults(mechanism, faults);
  return sentences(faults);
}

std::vector<std::string> broken_rules(const Mechanism& mechanism) {
  Faults faults;
  find_form_faults(mechanism, faults);
  if (faults.empty()) find_structure_faults(mechanism, faults);
  return sentences(faults);
}

void require_form(const Mechanism& mechanism) { require_unbroken(broken_form(mechanism)); }

void require_pose(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  const std::size_t each = mechanism.space == Space::planar ? 3 : 6;
  const std::size_t n =
      is_typed(mechanism) ? mechanism.unknowns.size() : each * (mechanism.bodies.size() - 1);
  if (static_cast<std::size_t>(q.size()) != n) {
    throw InvalidInput("a pose has " + std::to_string(n) +
                       " numbers, one for each coordinate, not " + std::to_string(q.size()));
  }
  if (!q.allFinite()) throw InvalidInput("a pose has a number that is not finite");
}

}  // namespace moivre
