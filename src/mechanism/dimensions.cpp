// SPDX-License-Identifier: MIT
// Names of a mechanism's numbers, and where each is kept.
#include "moivre/mechanism/dimensions.h"

#include <algorithm>
#include <cmath>

#include "moivre/expression/joined.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/numeric/invalid_input.h"
#include "read_parts.h"

namespace moivre {
namespace {

void add_points(const Mechanism& mechanism, std::vector<Dimension>& all) {
  constexpr const char* kAxes[] = {".x", ".y", ".z"};
  const int axes = mechanism.space == Space::planar ? 2 : 3;
  for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
    const std::vector<BodyPoint>& points = mechanism.bodies[body].points;
    for (std::size_t point = 0; point < points.size(); ++point) {
      for (int axis = 0; axis < axes; ++axis) {
        Dimension dimension;
        dimension.name = mechanism.bodies[body].name + "." + points[point].name + kAxes[axis];
        dimension.point = {body, point};
        dimension.axis = axis;
        all.push_back(std::move(dimension));
      }
    }
  }
}

void add_joints(const Mechanism& mechanism, std::vector<Dimension>& all) {
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    const Joint& joint = mechanism.joints[k];
    const bool is_rod = joint.type == JointType::rod;
    if (!is_rod && traits(joint.type).turn != JointTurn::not_at_all) continue;
    Dimension dimension;
    dimension.name = joint.name + (is_rod ? ".length" : ".turn");
    dimension.kind = is_rod ? DimensionKind::length : DimensionKind::turn;
    dimension.joint = k;
    dimension.is_angle = !is_rod;
    all.push_back(std::move(dimension));
  }
}

void add_drivers(const Mechanism& mechanism, std::vector<Dimension>& all) {
  for (std::size_t k = 0; k < mechanism.drivers.size(); ++k) {
    const Driver& driver = mechanism.drivers[k];
    const auto is_namesake = [&](const Driver& other) { return other.name == driver.name; };
    const bool is_only =
        std::count_if(mechanism.drivers.begin(), mechanism.drivers.end(), is_namesake) == 1;
    Dimension dimension;
    dimension.name = is_only ? driver.name : "driver " + driver.name + "." + to_string(driver.kind);
    dimension.kind = DimensionKind::driver;
    dimension.driver = k;
    dimension.is_angle = kind_of(mechanism, driver) != CoordinateKind::length;
    all.push_back(std::move(dimension));
  }
}

/// What the dimension is a number of.
void require_there(const Mechanism& mechanism, const Dimension& dimension) {
  const auto is_there = [&] {
    switch (dimension.kind) {
      case DimensionKind::point: {
        const PointOf& at = dimension.point;
        return at.body < mechanism.bodies.size() &&
               at.point < mechanism.bodies[at.body].points.size() && dimension.axis >= 0 &&
               dimension.axis < 3;
      }
      case DimensionKind::length:
      case DimensionKind::turn:
        return dimension.joint < mechanism.joints.size();
      case DimensionKind::driver:
        return dimension.driver < mechanism.drivers.size();
    }
    return false;
  };
  if (is_there()) return;
  throw InvalidInput("the dimension '" + dimension.name + "' is of something that is not there");
}

}  // namespace

std::vector<Dimension> dimensions(const Mechanism& mechanism) {
  std::vector<Dimension> all;
  add_points(mechanism, all);
  add_joints(mechanism, all);
  add_drivers(mechanism, all);
  return all;
}

std::vector<std::string> dimension_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const Dimension& dimension : dimensions(mechanism)) names.push_back(dimension.name);
  return names;
}

double dimension_value(const Mechanism& mechanism, const Dimension& dimension, double t) {
  require_there(mechanism, dimension);
  if (!std::isfinite(t)) throw InvalidInput("the time must be finite");
  const PointOf& at = dimension.point;
  switch (dimension.kind) {
    case DimensionKind::point:
      return mechanism.bodies[at.body].points[at.point].at[dimension.axis];
    case DimensionKind::length:
      return mechanism.joints[dimension.joint].length;
    case DimensionKind::turn:
      return mechanism.joints[dimension.joint].turn_rad;
    case DimensionKind::driver:
      require_law(mechanism.drivers[dimension.driver].law);
      return driver_state(mechanism.drivers[dimension.driver].law, t).value;
  }
  return 0;
}

double dimension_tolerance(const Mechanism& mechanism, const Dimension& dimension) {
  const auto typed = mechanism.tolerances.find(dimension.name);
  if (typed != mechanism.tolerances.end()) return typed->second;
  const bool is_made =
      dimension.kind == DimensionKind::point || dimension.kind == DimensionKind::length;
  return is_made ? mechanism.tolerance.value_or(0) : 0;
}

void set_dimension(Mechanism& mechanism, const Dimension& dimension, double value) {
  require_there(mechanism, dimension);
  if (!std::isfinite(value)) throw InvalidInput("a dimension must be finite");
  const PointOf& at = dimension.point;
  switch (dimension.kind) {
    case DimensionKind::point:
      mechanism.bodies[at.body].points[at.point].at[dimension.axis] = value;
      break;
    case DimensionKind::length:
      mechanism.joints[dimension.joint].length = value;
      break;
    case DimensionKind::turn:
      mechanism.joints[dimension.joint].turn_rad = value;
      break;
    case DimensionKind::driver:
      mechanism.drivers[dimension.driver].law = Parabola{value, 0, 0};
      break;
  }
}

void set_dimension(Mechanism& mechanism, const std::string& name, double value) {
  for (const Dimension& dimension : dimensions(mechanism)) {
    if (dimension.name != name) continue;
    const double unit = dimension.is_angle ? angle_unit(mechanism) : 1;
    return set_dimension(mechanism, dimension, value * unit);
  }
  throw InvalidInput("the mechanism has no number " + name + "; its numbers are " +
                     joined(dimension_names(mechanism), ", "));
}

}  // namespace moivre
