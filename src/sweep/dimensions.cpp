// SPDX-License-Identifier: MIT
// Names of a mechanism's numbers, and where each is kept.
#include "moivre/sweep/dimensions.h"

#include <functional>
#include <numbers>
#include <stdexcept>

#include "moivre/expression/joined.h"

namespace moivre {
namespace {

/// A name, and what sets its number.
struct Dimension {
  std::string name;
  std::function<void(double)> set;
};

double angle_unit(const Mechanism& mechanism) {
  constexpr double kStraight = 180;
  return mechanism.units.angle == "deg" ? std::numbers::pi / kStraight : 1;
}

void add_points(Mechanism& mechanism, std::vector<Dimension>& all) {
  constexpr const char* kAxes[] = {".x", ".y", ".z"};
  const int axes = mechanism.space == Space::planar ? 2 : 3;
  for (Body& body : mechanism.bodies) {
    for (BodyPoint& point : body.points) {
      for (int k = 0; k < axes; ++k) {
        all.push_back({body.name + "." + point.name + kAxes[k],
                       [&point, k](double value) { point.at[k] = value; }});
      }
    }
  }
}

void add_joints(Mechanism& mechanism, std::vector<Dimension>& all) {
  const double unit = angle_unit(mechanism);
  for (Joint& joint : mechanism.joints) {
    if (joint.type == JointType::rod) {
      all.push_back({joint.name + ".length", [&joint](double value) { joint.length = value; }});
    } else if (joint.type == JointType::prismatic || joint.type == JointType::weld) {
      all.push_back(
          {joint.name + ".turn", [&joint, unit](double value) { joint.turn_rad = value * unit; }});
    }
  }
}

bool is_angle(const Mechanism& mechanism, const Driver& driver) {
  if (driver.kind == DriverKind::unknown) return mechanism.unknowns[driver.unknown].is_angle;
  return driver.kind == DriverKind::angle;
}

std::vector<Dimension> dimensions(Mechanism& mechanism) {
  std::vector<Dimension> all;
  add_points(mechanism, all);
  add_joints(mechanism, all);
  for (Driver& driver : mechanism.drivers) {
    const double unit = is_angle(mechanism, driver) ? angle_unit(mechanism) : 1;
    all.push_back({driver.name, [&driver, unit](double value) {
                     driver.law = Parabola{value * unit, 0, 0};
                   }});
  }
  return all;
}

}  // namespace

std::vector<std::string> dimension_names(const Mechanism& mechanism) {
  Mechanism copy = mechanism;
  std::vector<std::string> names;
  for (const Dimension& dimension : dimensions(copy)) names.push_back(dimension.name);
  return names;
}

void set_dimension(Mechanism& mechanism, const std::string& name, double value) {
  for (const Dimension& dimension : dimensions(mechanism)) {
    if (dimension.name == name) return dimension.set(value);
  }
  throw std::invalid_argument("the mechanism has no number " + name + "; its numbers are " +
                              joined(dimension_names(mechanism), ", "));
}

}  // namespace moivre
