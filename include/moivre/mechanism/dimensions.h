// SPDX-License-Identifier: MIT
// Which numbers of a mechanism may be varied, and by what names? Dimensions of bodies and joints,
// and what drivers prescribe.
//
//   body.point.x, .y, .z    coordinate of a point in its body's frame      length, in the file's
//                           unit
//   joint.length            of a rod                                      length
//   joint.turn              of a prismatic joint or a weld                angle
//   a driver's name         its value: the law is replaced by it          in the file's units
// Where two drivers have one name, as x and y of one point have, they are called "driver
// coupler.P.x" and "driver coupler.P.y".
// By name a value is in the file's units, degrees where it says so; by Dimension angles are
// radians.
// A tolerance is how far a dimension may be off, up or down, in the units of its value: that typed
// for it, else Mechanism::tolerance for points and rods, else 0. Turns and drivers are exact where
// nothing is typed for them.
// Not supported: constants of typed equations, directions of lines and axes, teeth.
#pragma once

#include <string>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

enum class DimensionKind { point, length, turn, driver };

/// Which fields a kind reads is said beside them.
struct Dimension {
  std::string name;
  DimensionKind kind = DimensionKind::point;
  PointOf point;           ///< point
  int axis = 0;            ///< point: 0 x, 1 y, 2 z
  std::size_t joint = 0;   ///< length, turn
  std::size_t driver = 0;  ///< driver
  bool is_angle = false;
};

/// In the order of the file: points, joints, drivers.
std::vector<Dimension> dimensions(const Mechanism& mechanism);

/// Every name that set_dimension() takes.
std::vector<std::string> dimension_names(const Mechanism& mechanism);

/// Of a driver: what it prescribes at time t.
double dimension_value(const Mechanism& mechanism, const Dimension& dimension, double t = 0);
double dimension_tolerance(const Mechanism& mechanism, const Dimension& dimension);

void set_dimension(Mechanism& mechanism, const Dimension& dimension, double value);
/// Throws std::invalid_argument where there is no such name.
void set_dimension(Mechanism& mechanism, const std::string& name, double value);

}  // namespace moivre
