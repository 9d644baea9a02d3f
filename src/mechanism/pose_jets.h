// SPDX-License-Identifier: MIT
// Where are points and joints along a line of (q, t), on which a dimension may move too
// (dimension_jets.h)? In Jets, for every space.
#pragma once

#include <optional>

#include "dimension_jets.h"
#include "moivre/mechanism/joint_type.h"
#include "planar_pose.h"
#include "spatial_pose.h"

namespace moivre {

inline spatial::Vector<Jet> position_jet(const Mechanism& mechanism, const PointOf& point,
                                         const At<Jet>& at, const Dimension* moving = nullptr) {
  const spatial::Vector<Jet> s = point_jet(mechanism, point, moving);
  if (mechanism.space == Space::spatial) return spatial::position(at, point.body, s);
  const auto r = planar::position(at, point.body, {s.x, s.y});
  return {r.x, r.y, Jet(0)};
}

inline spatial::Vector<Jet> direction_jet(const Mechanism& mechanism, std::size_t body,
                                          const Eigen::Vector3d& s, const At<Jet>& at) {
  if (mechanism.space == Space::spatial) return spatial::direction(at, body, s);
  const auto e = planar::direction(at, body, s);
  return {e.x, e.y, Jet(0)};
}

/// Displacement of the joint's second point along its line; its distance from the first where there
/// is no line.
inline Jet joint_slide_jet(const Mechanism& mechanism, const Joint& joint, const At<Jet>& at,
                           const Dimension* moving = nullptr) {
  const auto gap = position_jet(mechanism, joint.at[1], at, moving) -
                   position_jet(mechanism, joint.at[0], at, moving);
  if (!has_line(joint.type)) return sqrt(spatial::dot(gap, gap));
  return spatial::dot(direction_jet(mechanism, line_body(joint), joint.axis[0], at), gap);
}

/// Angle of the joint's second body relative to the first; spatial: about its axis.
inline Jet joint_turn_jet(const Mechanism& mechanism, const Joint& joint, const At<Jet>& at) {
  const std::size_t first = joint.at[0].body;
  const std::size_t second = joint.at[1].body;
  if (mechanism.space == Space::planar) return planar::angle(at, second) - planar::angle(at, first);
  const Eigen::Matrix3d frame = spatial::axis_frame(joint.axis[0]);
  const Eigen::Vector3d pointer = spatial::axis_frame(joint.axis[1]).col(0);
  const auto shown = direction_jet(mechanism, second, pointer, at);
  return atan2(spatial::dot(direction_jet(mechanism, first, frame.col(1), at), shown),
               spatial::dot(direction_jet(mechanism, first, frame.col(0), at), shown));
}

/// The joint's coordinate: its slide where it has one, else its angle; none of a joint that has
/// neither.
inline std::optional<Jet> joint_jet(const Mechanism& mechanism, const Joint& joint,
                                    const At<Jet>& at, const Dimension* moving = nullptr) {
  if (has_slide(joint.type)) return joint_slide_jet(mechanism, joint, at, moving);
  if (has_angle(joint.type)) return joint_turn_jet(mechanism, joint, at);
  return std::nullopt;
}

}  // namespace moivre
