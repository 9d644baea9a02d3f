// SPDX-License-Identifier: MIT
// Gauss-Jordan elimination with exact coefficients; the right-hand sides are angles.
#include "meshings.h"

#include <cmath>
#include <iterator>
#include <map>

#include "moivre/mechanism/joint_type.h"
#include "moivre/numeric/rational.h"

namespace moivre {
namespace {

// Angles of the file in radians, added up: equal ones differ by far less.
constexpr double kSameTurn = 1e-9;

/// sum of coefficients times angles = value, which is `exact` as it was typed.
struct Row {
  std::map<std::size_t, Rational> coefficients;
  double value = 0;
  ExactAngle exact = {};
};

void subtract(Row& row, const Rational& factor, const Row& other) {
  for (const auto& [body, coefficient] : other.coefficients) {
    Rational& mine = row.coefficients[body];
    mine = mine - factor * coefficient;
    if (mine == 0) row.coefficients.erase(body);
  }
  row.value -= to_double(factor) * other.value;
  row.exact = plus(row.exact, times(-factor, other.exact));
}

class Angles {
 public:
  /// False where the row contradicts those before it.
  bool add(Row row) {
    row.coefficients.erase(0);
    for (const auto& [pivot, solved] : rows_) {
      const auto found = row.coefficients.find(pivot);
      if (found == row.coefficients.end()) continue;
      const Rational factor = found->second;
      subtract(row, factor, solved);
    }
    if (row.coefficients.empty()) return std::abs(row.value) <= kSameTurn;
    const std::size_t pivot = row.coefficients.begin()->first;
    const Rational scale = 1 / row.coefficients.begin()->second;
    for (auto& entry : row.coefficients) entry.second = entry.second * scale;
    row.value *= to_double(scale);
    row.exact = times(scale, row.exact);
    for (auto& entry : rows_) {
      const auto found = entry.second.coefficients.find(pivot);
      if (found == entry.second.coefficients.end()) continue;
      const Rational factor = found->second;
      subtract(entry.second, factor, row);
    }
    rows_.emplace(pivot, std::move(row));
    return true;
  }

  std::vector<std::optional<KnownAngle>> take(std::size_t bodies) const {
    std::vector<std::optional<KnownAngle>> angles;
    for (std::size_t body = 0; body < bodies; ++body) {
      const auto found = rows_.find(body);
      angles.push_back(found == rows_.end() ? KnownAngle{body} : solved(found->second));
    }
    return angles;
  }

 private:
  /// Of a row a_pivot - a_free = value, or a_pivot = value.
  static std::optional<KnownAngle> solved(const Row& row) {
    if (row.coefficients.size() == 1) return KnownAngle{0, row.value, row.exact};
    const auto free = std::next(row.coefficients.begin());
    if (row.coefficients.size() > 2 || free->second != -1) return std::nullopt;
    return KnownAngle{free->first, row.value, row.exact};
  }

  std::map<std::size_t, Row> rows_;  ///< by pivot, whose coefficient is 1 and 0 in all other rows
};

Row difference(std::size_t i, std::size_t j, double value, const ExactAngle& exact) {
  return {{{j, 1}, {i, -1}}, value, exact};
}

Row gear_row(const Joint& joint, const Units& units) {
  const Rational zi = joint.gear.teeth[0];
  const Rational zj = joint.gear.teeth[1];
  Row row;
  row.coefficients[joint.at[0].body] = zi;
  row.coefficients[joint.at[1].body] = -zj;
  Rational& carrier = row.coefficients[joint.gear.carrier];
  carrier = carrier + zj - zi;
  if (carrier == 0) row.coefficients.erase(joint.gear.carrier);
  row.value = -joint.gear.teeth[1] * joint.gear.phase_rad;
  row.exact = times(-zj, typed_angle(joint.gear.phase_rad, units));
  return row;
}

}  // namespace

std::size_t turn_body(const Joint& joint) {
  return joint.type == JointType::rack ? joint.at[0].body : joint.gear.carrier;
}

double turn_by(const Joint& joint, double slide) {
  return joint.type == JointType::rack ? joint.gear.phase_rad + slide / joint.radius : slide;
}

std::vector<std::optional<KnownAngle>> known_angles(
    const Mechanism& mechanism, double t, const std::vector<std::optional<KnownSlide>>& slides) {
  Angles angles;
  bool agrees = true;
  for (const Driver& driver : mechanism.drivers) {
    if (driver.kind != DriverKind::angle) continue;
    const double value = driver_state(driver.law, t).value;
    agrees &= angles.add(difference(driver.bodies[0], driver.bodies[1], value,
                                    driven_angle(driver.law, t, mechanism.units)));
  }
  for (const Joint& joint : mechanism.joints) {
    if (traits(joint.type).turn == JointTurn::not_at_all) {
      agrees &= angles.add(difference(joint.at[0].body, joint.at[1].body, joint.turn_rad,
                                      typed_angle(joint.turn_rad, mechanism.units)));
    } else if (traits(joint.type).turn == JointTurn::geared && !joint.gear.has_all_meshings) {
      agrees &= angles.add(gear_row(joint, mechanism.units));
    }
  }
  // A slide that disagrees with the angles is reported by who knows both.
  for (std::size_t k = 0; k < slides.size(); ++k) {
    const Joint& joint = mechanism.joints[k];
    if (!slides[k] || joint.type == JointType::cam) continue;
    const double turn = turn_by(joint, slides[k]->value);
    angles.add(difference(turn_body(joint), joint.at[1].body, turn, computed_angle(turn)));
  }
  if (!agrees) return std::vector<std::optional<KnownAngle>>(mechanism.bodies.size());
  return angles.take(mechanism.bodies.size());
}

bool is_settled(const Joint& gear, const std::vector<std::optional<KnownAngle>>& angles) {
  const auto& i = angles[gear.at[0].body];
  const auto& j = angles[gear.at[1].body];
  const auto& c = angles[gear.gear.carrier];
  return !gear.gear.has_all_meshings && i && j && c && i->root == j->root && i->root == c->root;
}

}  // namespace moivre
