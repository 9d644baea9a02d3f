// SPDX-License-Identifier: MIT
// Bodies from links, symbols slid apart, and twenty-four eyes compared.
#include "skeleton.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Relative to the arm's length.
constexpr double kOnePlace = 0.02;
constexpr double kSlide = 0.1;

/// Whether the axes before and behind the joint pass through its origin: the middle of a wrist,
/// whose flip would not be seen.
bool is_between_meeting_axes(const Arm& arm, std::size_t k) {
  if (k == 0 || k + 1 == arm.joints.size()) return false;
  const Eigen::Isometry3d& before = arm.joints[k].before;
  const Eigen::Isometry3d& next = arm.joints[k + 1].before;
  const Vector3d next_axis = next.linear() * arm.joints[k + 1].axis;
  const double near = kOnePlace * arm.length;
  return arm.joints[k - 1].axis.cross(before.translation()).norm() <= near &&
         next_axis.cross(next.translation()).norm() <= near;
}

/// Where each joint's symbol stands, in the joint's own frame.
std::vector<Vector3d> symbols(const Arm& arm) {
  const std::size_t n = arm.joints.size();
  const double near = kOnePlace * arm.length;
  std::vector<Vector3d> places;
  for (std::size_t k = 0; k < n; ++k) {
    const ArmJoint& joint = arm.joints[k];
    const Eigen::Isometry3d& next = k + 1 < n ? arm.joints[k + 1].before : arm.tool;
    if (next.translation().norm() > near && !is_between_meeting_axes(arm, k)) {
      places.emplace_back(Vector3d::Zero());
      continue;
    }
    // Towards where the arm comes from, if that is along the axis at all.
    const double from =
        -joint.axis.dot(joint.before.linear().transpose() * joint.before.translation());
    const bool is_ahead = from > 0.5 * std::max(joint.before.translation().norm(), near);
    places.emplace_back((is_ahead ? 1 : -1) * kSlide * arm.length * joint.axis);
  }
  return places;
}

/// Adds the point and tells which it is.
PointOf add_point(Mechanism& mechanism, std::size_t body, const std::string& name,
                  const Vector3d& at) {
  std::vector<BodyPoint>& points = mechanism.bodies[body].points;
  points.push_back({name, at, {}});
  return {body, points.size() - 1};
}

void add_joint(Mechanism& mechanism, JointType type, PointOf parent, PointOf child,
               const Vector3d& in_parent, const Vector3d& in_child) {
  Joint joint;
  joint.type = type;
  joint.at = {parent, child};
  joint.axis = {in_parent, in_child};
  mechanism.joints.push_back(joint);
}

/// Points that a body has in the ground's frame.
std::vector<Vector3d> places_of(const Mechanism& mechanism, const VectorXd& q) {
  std::vector<Vector3d> places;
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (std::size_t k = 0; k < mechanism.bodies[body].points.size(); ++k) {
      places.push_back(point_position(mechanism, {body, k}, q));
    }
  }
  return places;
}

}  // namespace

Skeleton make_skeleton(const Arm& arm) {
  Skeleton skeleton;
  Mechanism& mechanism = skeleton.mechanism;
  mechanism.space = Space::spatial;
  mechanism.units.length = "m";
  mechanism.bodies[0].points.clear();
  // The base's column is a body like the links, so that it is drawn; it stands.
  mechanism.bodies.push_back({});
  const bool has_column = arm.joints.front().before.translation().norm() > kOnePlace * arm.length;
  if (has_column) {
    const PointOf ground = add_point(mechanism, 0, "", Vector3d::Zero());
    const PointOf foot = add_point(mechanism, 1, "", Vector3d::Zero());
    add_joint(mechanism, JointType::weld, ground, foot, Vector3d::UnitZ(), Vector3d::UnitZ());
  }
  const std::vector<Vector3d> places = symbols(arm);
  for (std::size_t k = 0; k < arm.joints.size(); ++k) {
    const ArmJoint& joint = arm.joints[k];
    const std::string name = std::to_string(k + 1);
    const std::size_t parent = k == 0 && !has_column ? 0 : k + 1;
    mechanism.bodies.push_back({});
    const PointOf on_parent = add_point(mechanism, parent, name, joint.before * places[k]);
    const PointOf on_child = add_point(mechanism, k + 2, name, places[k]);
    add_joint(mechanism, joint.is_slide ? JointType::prismatic : JointType::revolute, on_parent,
              on_child, joint.before.linear() * joint.axis, joint.axis);
    if (joint.is_slide) {
      add_joint(mechanism, JointType::rod, on_parent, on_child, joint.axis, joint.axis);
    }
  }
  const std::size_t last = mechanism.bodies.size() - 1;
  add_point(mechanism, last, arm.tip, arm.tool.translation());
  skeleton.frames = {{{0, Vector3d::Zero()}, Eigen::Matrix3d::Identity(), true},
                     {{last, arm.tool.translation()}, arm.tool.linear(), false}};
  return skeleton;
}

VectorXd skeleton_pose(const Skeleton& skeleton, const Arm& arm, const VectorXd& values) {
  VectorXd q = VectorXd::Zero(6 * static_cast<Eigen::Index>(skeleton.mechanism.bodies.size() - 1));
  Eigen::Index begin = 6;  // behind the column
  for (const Eigen::Isometry3d& frame : joint_frames(arm, values)) {
    const Eigen::AngleAxisd turn(frame.linear());
    q.segment<3>(begin) = frame.translation();
    q.segment<3>(begin + 3) = turn.angle() * turn.axis();
    begin += 6;
  }
  return q;
}

Eye best_eye(const Skeleton& skeleton, const std::vector<VectorXd>& poses) {
  constexpr int kEyes = 24;
  std::vector<std::vector<Vector3d>> places;
  for (const VectorXd& q : poses) places.push_back(places_of(skeleton.mechanism, q));
  Eye best;
  double most = -1;
  for (int k = 0; k < kEyes; ++k) {
    Eye eye;
    eye.azimuth_rad += 2 * std::numbers::pi * k / kEyes;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < places.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        double apart = 0;
        for (std::size_t i = 0; i < places[a].size(); ++i) {
          apart =
              std::max(apart, std::abs(seen(skeleton.mechanism, places[a][i] - places[b][i], eye)));
        }
        least = std::min(least, apart);
      }
    }
    if (least <= most) continue;
    most = least;
    best = eye;
  }
  return best;
}

}  // namespace moivre
