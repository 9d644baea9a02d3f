// SPDX-License-Identifier: MIT
// Which coordinates has a mechanism, and what are its parts called?
#include "moivre/mechanism/mechanism.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/rules.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {

std::string to_string(DriverKind kind) {
  switch (kind) {
    case DriverKind::angle:
      return "angle";
    case DriverKind::slide:
      return "slide";
    case DriverKind::x:
      return "x";
    case DriverKind::y:
      return "y";
    case DriverKind::z:
      return "z";
    case DriverKind::unknown:
      return "unknown";
  }
  return "";
}

namespace {

std::string time_text(double t) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", t);
  return text;
}

}  // namespace

std::size_t line_body(const Joint& joint) {
  return joint.type == JointType::cam ? joint.gear.carrier : joint.at[0].body;
}

std::vector<std::size_t> bodies_of(const Joint& joint) {
  std::vector<std::size_t> bodies{joint.at[0].body, joint.at[1].body};
  if (is_transmission(joint.type)) bodies.push_back(joint.gear.carrier);
  return bodies;
}

std::vector<std::size_t> bodies_of(const Mechanism& mechanism, const Driver& driver) {
  switch (driver.kind) {
    case DriverKind::angle:
      if (mechanism.space == Space::spatial) return bodies_of(mechanism.joints[driver.joint]);
      return {driver.bodies[0], driver.bodies[1]};
    case DriverKind::slide:
      return bodies_of(mechanism.joints[driver.joint]);
    case DriverKind::x:
    case DriverKind::y:
    case DriverKind::z:
      return {driver.point.body};
    case DriverKind::unknown:
      break;
  }
  return {};
}

bool is_typed(const Mechanism& mechanism) { return !mechanism.unknowns.empty(); }

bool is_workable(double number) { return std::abs(number) <= kLargestSize; }

bool is_workable_angle(double angle_rad) {
  return std::abs(angle_rad) <= kMostTurns * 2 * std::numbers::pi;
}

void require_drivers(const Mechanism& mechanism, double t) {
  require_form(mechanism);
  if (!std::isfinite(t)) throw InvalidInput("the time of the drivers must be finite");
  std::string broken;
  for (const Driver& driver : mechanism.drivers) {
    const double value = driver_state(driver.law, t).value;
    const bool is_angle = kind_of(mechanism, driver) == CoordinateKind::angle;
    std::string fault;
    if (!std::isfinite(value)) {
      fault = "no finite value";
    } else if (is_angle && !is_workable_angle(value)) {
      fault = "more than a million turns";
    } else if (!is_angle && !is_workable(value)) {
      fault = "a length beyond 1e50";
    }
    if (fault.empty()) continue;
    broken += (broken.empty() ? "at t = " + time_text(t) + " s driver '" : ", driver '") +
              driver.name + "' prescribes " + fault;
  }
  if (!broken.empty()) throw InvalidInput(broken);
}

std::vector<Coordinate> coordinates(const Mechanism& mechanism) {
  std::vector<Coordinate> q;
  if (is_typed(mechanism)) {
    for (const Unknown& unknown : mechanism.unknowns) {
      const std::size_t k = q.size();
      const auto kind = unknown.is_angle ? CoordinateKind::angle : CoordinateKind::length;
      const bool repeats = std::all_of(
          mechanism.equations.begin(), mechanism.equations.end(),
          [&](const Equation& equation) { return repeats_by_turns(equation.formula, k); });
      q.push_back({unknown.name, kind, k, unknown.is_angle && repeats});
    }
    return q;
  }
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    const auto add = [&](const char* name, CoordinateKind kind) {
      q.push_back({mechanism.bodies[body].name + "." + name, kind, body - 1,
                   kind == CoordinateKind::angle});
    };
    add("x", CoordinateKind::length);
    add("y", CoordinateKind::length);
    if (mechanism.space == Space::planar) {
      add("phi", CoordinateKind::angle);
    } else {
      add("z", CoordinateKind::length);
      for (const char* name : {"rx", "ry", "rz"}) add(name, CoordinateKind::rotation_vector);
    }
  }
  return q;
}

CoordinateKind kind_of(const Mechanism& mechanism, const Driver& driver) {
  const bool is_angle = driver.kind == DriverKind::unknown
                            ? mechanism.unknowns[driver.unknown].is_angle
                            : driver.kind == DriverKind::angle;
  return is_angle ? CoordinateKind::angle : CoordinateKind::length;
}

std::string label_of(const Driver& driver) {
  const bool is_place =
      driver.kind == DriverKind::x || driver.kind == DriverKind::y || driver.kind == DriverKind::z;
  return is_place ? driver.name + "." + to_string(driver.kind) : driver.name;
}

}  // namespace moivre
