// SPDX-License-Identifier: MIT
// Dual quaternions evaluated and multiplied along the tree; links between points by frames.
#include "moivre/formulation/pose_reading.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "moivre/mechanism/spins.h"
#include "moivre/polynomial/value.h"

namespace moivre {
namespace {

using Eigen::Vector3d;

Eigen::Isometry3d to_isometry(const DualQuaternion<double>& pose) {
  const Quaternion<double>& q = pose.q;
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
  if (!(dot(q, q) > 0)) return placed;
  const Quaternion<double> shift = shift_of(pose);
  placed.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  placed.translation() << shift[1], shift[2], shift[3];
  return placed;
}

/// A real pose may come with a complex factor: its largest turn number becomes 1.
Eigen::Isometry3d relative_pose(const DualQuaternion<Polynomial>& relative, const Point& root) {
  const auto values = mapped(relative, [&](const Polynomial& p) { return value_at(p, root); });
  const Complex factor = *std::max_element(
      values.q.begin(), values.q.end(),
      [](const Complex& a, const Complex& b) { return std::norm(a) < std::norm(b); });
  return to_isometry(mapped(
      values, [&](const Complex& value) { return factor == 0.0 ? 0 : (value / factor).real(); }));
}

/// x towards b - a, y on the side of c.
Eigen::Matrix3d frame_through(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Eigen::Matrix3d frame;
  frame.col(0) = (b - a).normalized();
  frame.col(2) = (b - a).cross(c - a).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

Eigen::Isometry3d placed_by_points(const std::vector<PoseReading::PointPair>& pairs,
                                   const std::vector<Eigen::Isometry3d>& groups) {
  std::vector<Vector3d> here;
  std::vector<Vector3d> there;
  for (const auto& pair : pairs) {
    here.push_back(pair.here);
    there.push_back(groups[pair.group] * pair.there);
  }
  if (pairs.size() == 2) {
    here.push_back(here[0] + spin_mark());
    there.push_back(there[0] + spin_mark());
  }
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
  placed.linear() = frame_through(there[0], there[1], there[2]) *
                    frame_through(here[0], here[1], here[2]).transpose();
  placed.translation() = there[0] - placed.linear() * here[0];
  return placed;
}

}  // namespace

Eigen::VectorXd coordinates_of_root(const PoseReading& reading, const Point& root) {
  constexpr Eigen::Index kSize = 6;
  std::vector<Eigen::Isometry3d> groups(reading.groups, Eigen::Isometry3d::Identity());
  for (const PoseReading::Placement& placement : reading.placements) {
    groups[placement.group] = placement.points.empty() ? groups[placement.parent] *
                                                             relative_pose(placement.relative, root)
                                                       : placed_by_points(placement.points, groups);
  }
  Eigen::VectorXd q(kSize * static_cast<Eigen::Index>(reading.bodies.size()));
  Eigen::Index at = 0;
  for (const PoseReading::BodyPose& body : reading.bodies) {
    const Eigen::Isometry3d pose = groups[body.group] * to_isometry(body.in_group);
    const Eigen::AngleAxisd turn(pose.linear());
    q.segment<3>(at) = pose.translation();
    q.segment<3>(at + 3) = turn.angle() * turn.axis();
    at += kSize;
  }
  return q;
}

}  // namespace moivre
