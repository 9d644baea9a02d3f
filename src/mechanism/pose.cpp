// SPDX-License-Identifier: MIT
// How are points, orientations and joint coordinates read off q?
#include "moivre/mechanism/pose.h"

#include <cmath>
#include <numbers>

#include "planar_pose.h"
#include "spatial_pose.h"

namespace moivre {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

using JetVector = spatial::Vector<Jet>;

JetVector position(const Mechanism& mechanism, const PointOf& point, const At<Jet>& at) {
  const Vector3d& s = mechanism.bodies[point.body].points[point.point].at;
  if (mechanism.space == Space::spatial) return spatial::position(at, point.body, s);
  const auto r = planar::position(at, point.body, s);
  return {r.x, r.y, Jet(0)};
}

/// Angle of the second body relative to the first about the joint's axis.
double relative_angle(const Mechanism& mechanism, const Joint& joint, const VectorXd& q) {
  const Matrix3d first = orientation(mechanism, joint.at[0].body, q);
  const Matrix3d second = orientation(mechanism, joint.at[1].body, q);
  Matrix3d turn = first.transpose() * second;
  if (mechanism.space == Space::spatial) {
    turn =
        spatial::axis_frame(joint.axis[0]).transpose() * turn * spatial::axis_frame(joint.axis[1]);
  }
  return std::atan2(turn(1, 0), turn(0, 0));
}

double slide(const Mechanism& mechanism, const Joint& joint, const VectorXd& q) {
  const Vector3d along = orientation(mechanism, joint.at[0].body, q) * joint.axis[0];
  return along.dot(point_position(mechanism, joint.at[1], q) -
                   point_position(mechanism, joint.at[0], q));
}

}  // namespace

PointState point_state(const Mechanism& mechanism, const PointOf& point, const VectorXd& q,
                       const VectorXd& qdot, const VectorXd& qddot) {
  std::vector<Jet> jets;
  for (Eigen::Index k = 0; k < q.size(); ++k) jets.emplace_back(q[k], qdot[k], qddot[k]);
  const JetVector r = position(mechanism, point, {jets, Jet(0)});
  return {{r.x.f, r.y.f, r.z.f}, {r.x.d, r.y.d, r.z.d}, {r.x.dd, r.y.dd, r.z.dd}};
}

Vector3d point_position(const Mechanism& mechanism, const PointOf& point, const VectorXd& q) {
  const VectorXd rest = VectorXd::Zero(q.size());
  return point_state(mechanism, point, q, rest, rest).position;
}

Matrix3d orientation(const Mechanism& mechanism, std::size_t body, const VectorXd& q) {
  const std::vector<Jet> jets(q.begin(), q.end());
  const At<Jet> at{jets, Jet(0)};
  Matrix3d R = Matrix3d::Identity();
  for (int k = 0; k < 3; ++k) {
    const Vector3d axis = Vector3d::Unit(k);
    if (mechanism.space == Space::spatial) {
      const auto column = spatial::direction(at, body, axis);
      R.col(k) << column.x.f, column.y.f, column.z.f;
    } else if (k < 2) {
      const auto column = planar::direction(at, body, axis);
      R.col(k) << column.x.f, column.y.f, 0;
    }
  }
  return R;
}

Matrix3d joint_frame(const Vector3d& axis) { return spatial::axis_frame(axis); }

std::optional<double> joint_coordinate(const Mechanism& mechanism, const Joint& joint,
                                       const VectorXd& q) {
  switch (joint.type) {
    case JointType::revolute:
      return relative_angle(mechanism, joint, q);
    case JointType::prismatic:
    case JointType::slot:
    case JointType::cylindrical:
      return slide(mechanism, joint, q);
    case JointType::weld:
    case JointType::rod:
    case JointType::gear:
    case JointType::spherical:
    case JointType::universal:
      break;
  }
  return std::nullopt;
}

bool is_within_limits(const Mechanism& mechanism, const Joint& joint, const VectorXd& q) {
  const auto value = joint_coordinate(mechanism, joint, q);
  if (!joint.limits || !value) return true;
  double above_lower = *value - joint.limits->lower;
  if (joint.type == JointType::revolute) {
    constexpr double kTurn = 2 * std::numbers::pi;
    above_lower -= kTurn * std::floor(above_lower / kTurn);
  }
  return above_lower >= 0 && above_lower <= joint.limits->upper - joint.limits->lower;
}

}  // namespace moivre
