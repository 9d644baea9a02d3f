// SPDX-License-Identifier: MIT
// Where does q put a body and its points, how fast do they move, and where do the joints stand?
//
// Positions by Taylor arithmetic along q(s): with q, q', q'' given, a point's position, velocity
// and acceleration follow exactly.
// Not for typed mechanisms, which have no bodies.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <string>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// In the ground frame; planar points have z = 0.
struct PointState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
};

/// q, qdot = q', qddot = q'', each with n entries; for position alone give zeros.
PointState point_state(const Mechanism& mechanism, const PointOf& point, const Eigen::VectorXd& q,
                       const Eigen::VectorXd& qdot, const Eigen::VectorXd& qddot);

/// Of every point of the moving bodies: body after body, point after point.
std::vector<PointState> point_states(const Mechanism& mechanism, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& qdot, const Eigen::VectorXd& qddot);

Eigen::Vector3d point_position(const Mechanism& mechanism, const PointOf& point,
                               const Eigen::VectorXd& q);

/// The point "coupler.C", or "ground.A". Throws InvalidInput where there is none, with those that
/// there are.
PointOf point_named(const Mechanism& mechanism, const std::string& name);

/// point_position(mechanism, "coupler.C", q)
template <std::convertible_to<std::string> Name>
Eigen::Vector3d point_position(const Mechanism& mechanism, const Name& name,
                               const Eigen::VectorXd& q) {
  return point_position(mechanism, point_named(mechanism, name), q);
}

/// R of a body: columns are its axes in the ground frame.
Eigen::Matrix3d orientation(const Mechanism& mechanism, std::size_t body, const Eigen::VectorXd& q);

/// The frame of a spatial joint in a body: z along the axis, x by a fixed rule, so that equal axes
/// make equal frames.
Eigen::Matrix3d joint_frame(const Eigen::Vector3d& axis);

/// The joint's coordinate (joint_type.h): displacement of the second point along the line or
/// distance from the first, or angle of the second body relative to the first in [-pi, pi]; nothing
/// for joints that have none.
std::optional<double> joint_coordinate(const Mechanism& mechanism, const Joint& joint,
                                       const Eigen::VectorXd& q);

/// A number that moves with the pose, and how fast.
struct ScalarState {
  double value = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// What joint_coordinate tells, in motion. Planar angles go on beyond half a turn with those of the
/// bodies.
std::optional<ScalarState> joint_state(const Mechanism& mechanism, const Joint& joint,
                                       const Eigen::VectorXd& q, const Eigen::VectorXd& qdot,
                                       const Eigen::VectorXd& qddot);

/// Angle of the joint's second body relative to the first: planar; spatial about the joint's axis,
/// in [-pi, pi].
ScalarState turn_state(const Mechanism& mechanism, const Joint& joint, const Eigen::VectorXd& q,
                       const Eigen::VectorXd& qdot, const Eigen::VectorXd& qddot);

/// Whether the joint stands within its limits (true where it has none); angles count modulo whole
/// turns.
bool is_within_limits(const Mechanism& mechanism, const Joint& joint, const Eigen::VectorXd& q);

/// The first joint that does not; nullptr where all do.
const Joint* broken_limit(const Mechanism& mechanism, const Eigen::VectorXd& q);

}  // namespace moivre
