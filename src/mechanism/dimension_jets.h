// SPDX-License-Identifier: MIT
// What is a dimension along a line on which one of them moves? A Jet: its value, and 1 as first
// derivative where it is the one.
//
// `moving` is null where none moves; joints and drivers are those of the mechanism, by reference.
#pragma once

#include "moivre/mechanism/dimensions.h"
#include "spatial_pose.h"

namespace moivre {

/// A point in its body's frame.
inline spatial::Vector<Jet> point_jet(const Mechanism& mechanism, const PointOf& point,
                                      const Dimension* moving) {
  spatial::Vector<Jet> at = spatial::constant(mechanism.bodies[point.body].points[point.point].at);
  const bool moves = moving != nullptr && moving->kind == DimensionKind::point &&
                     moving->point.body == point.body && moving->point.point == point.point;
  if (moves) (moving->axis == 0 ? at.x : moving->axis == 1 ? at.y : at.z).d = 1;
  return at;
}

inline bool is_moving(const Mechanism& mechanism, const Joint& joint, DimensionKind kind,
                      const Dimension* moving) {
  return moving != nullptr && moving->kind == kind && &mechanism.joints[moving->joint] == &joint;
}

inline Jet turn_jet(const Mechanism& mechanism, const Joint& joint, const Dimension* moving) {
  const bool moves = is_moving(mechanism, joint, DimensionKind::turn, moving);
  return {joint.turn_rad, moves ? 1.0 : 0.0, 0};
}

inline Jet length_jet(const Mechanism& mechanism, const Joint& joint, const Dimension* moving) {
  const bool moves = is_moving(mechanism, joint, DimensionKind::length, moving);
  return {joint.length, moves ? 1.0 : 0.0, 0};
}

inline Prescription prescription(const Mechanism& mechanism, const Driver& driver,
                                 const Dimension* moving) {
  const bool moves = moving != nullptr && moving->kind == DimensionKind::driver &&
                     &mechanism.drivers[moving->driver] == &driver;
  return {driver.law, moves ? 1.0 : 0.0};
}

}  // namespace moivre
