// SPDX-License-Identifier: MIT
// Where does Newton's method start? In the drawn pose where that closes, else with bodies placed
// joint by joint from the ground outwards, at guessed or driven angles; slides that nothing drives
// stand as drawn.
#include <Eigen/Geometry>

#include "moivre/mechanism/drawn_pose.h"
#include "moivre/mechanism/driven_joint.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/mechanism/rules.h"
#include "spatial_pose.h"

namespace moivre {
namespace {

/// Pose of a body in the ground frame; planar bodies turn about z.
struct Pose {
  Eigen::Vector3d r = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  bool is_placed = false;
};

Eigen::Matrix3d turn_about(const Eigen::Vector3d& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

class Placement {
 public:
  Placement(const Mechanism& mechanism, double t)
      : mechanism_(mechanism),
        t_(t),
        is_drawn_(is_drawn(mechanism)),
        poses_(mechanism.bodies.size()) {
    poses_[0].is_placed = true;
  }

  /// Ring by ring: bodies at the ground first, then those at them. Actuators place what nothing
  /// else does.
  std::vector<Pose> place_all() {
    while (place_ring(false) || place_ring(true)) {
    }
    return std::move(poses_);
  }

 private:
  bool place_ring(bool by_actuators) {
    bool has_moved = false;
    const std::vector<Pose> before = poses_;
    for (const Joint& joint : mechanism_.joints) {
      const bool is_actuator = joint.type == JointType::actuator;
      if (is_transmission(joint.type) || is_actuator != by_actuators) continue;
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const std::size_t to = joint.at[1 - end].body;
        if (!before[joint.at[end].body].is_placed || poses_[to].is_placed) continue;
        poses_[to] = placed(joint, end);
        has_moved = true;
      }
    }
    return has_moved;
  }

  const Eigen::Vector3d& point(const PointOf& p) const {
    return mechanism_.bodies[p.body].points[p.point].at;
  }

  std::optional<double> guess(std::size_t body, const char* coordinate) const {
    const auto found = mechanism_.guess.find(mechanism_.bodies[body].name + "." + coordinate);
    if (found == mechanism_.guess.end()) return std::nullopt;
    return found->second;
  }

  /// The driven angle of `body`, where a driver turns it relative to a body that stands already.
  std::optional<double> driven_angle(std::size_t body) const {
    for (const Driver& driver : mechanism_.drivers) {
      if (driver.kind != DriverKind::angle || driver.bodies[1] != body) continue;
      const Pose& base = poses_[driver.bodies[0]];
      if (base.is_placed) return std::atan2(base.R(1, 0), base.R(0, 0)) + value(driver);
    }
    return std::nullopt;
  }

  DrivenJoint driven(const Joint& joint) const {
    return driven_joint(mechanism_, static_cast<std::size_t>(&joint - mechanism_.joints.data()),
                        t_);
  }

  double value(const Driver& driver) const { return driver_state(driver.law, t_).value; }

  Eigen::Matrix3d planar_orientation(const Joint& joint, std::size_t end, std::size_t body) const {
    if (const auto phi = guess(body, "phi")) return turn_about(Eigen::Vector3d::UnitZ(), *phi);
    if (const auto phi = driven_angle(body)) return turn_about(Eigen::Vector3d::UnitZ(), *phi);
    if (traits(joint.type).turn != JointTurn::not_at_all) return Eigen::Matrix3d::Identity();
    const double turn = end == 0 ? joint.turn_rad : -joint.turn_rad;
    return poses_[joint.at[end].body].R * turn_about(Eigen::Vector3d::UnitZ(), turn);
  }

  Eigen::Matrix3d spatial_orientation(const Joint& joint, std::size_t end, std::size_t body) const {
    const auto rx = guess(body, "rx"), ry = guess(body, "ry"), rz = guess(body, "rz");
    if (rx || ry || rz) {
      const Eigen::Vector3d v(rx.value_or(0), ry.value_or(0), rz.value_or(0));
      return v.isZero(0) ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                         : turn_about(v.normalized(), v.norm());
    }
    const Eigen::Matrix3d& base = poses_[joint.at[end].body].R;
    const JointTurn freedom = traits(joint.type).turn;
    if (freedom == JointTurn::freely || freedom == JointTurn::about_two_axes) return base;
    const double turn = driven(joint).angle.value_or(0);
    const Eigen::Matrix3d relative = spatial::axis_frame(joint.axis[0]) *
                                     turn_about(Eigen::Vector3d::UnitZ(), joint.turn_rad + turn) *
                                     spatial::axis_frame(joint.axis[1]).transpose();
    return base * (end == 0 ? relative : Eigen::Matrix3d(relative.transpose()));
  }

  /// From the point that stands to the one that is placed: as far apart as driven or as long, along
  /// the joint's line.
  Eigen::Vector3d gap_along_line(const Joint& joint, std::size_t end,
                                 const Eigen::Matrix3d& R) const {
    double apart = driven(joint).slide.value_or(0);
    if (joint.type == JointType::rod) apart = joint.length;
    return end == 0 ? Eigen::Vector3d(apart * poses_[joint.at[0].body].R * joint.axis[0])
                    : Eigen::Vector3d(-apart * R * joint.axis[0]);
  }

  /// The same as it is drawn, turned with the body that stands; a length or a slide that is given
  /// counts.
  Eigen::Vector3d drawn_gap(const Joint& joint, std::size_t end) const {
    const Eigen::Vector3d drawn = point(joint.at[1 - end]) - point(joint.at[end]);
    const Eigen::Matrix3d& base = poses_[joint.at[end].body].R;
    std::optional<double> length = driven(joint).slide;
    if (joint.type == JointType::rod) length = joint.length;
    if (!length || drawn.isZero(0)) return base * drawn;
    if (joint.type == JointType::rod || joint.type == JointType::actuator) {
      return base * drawn.normalized() * *length;
    }
    const double sign = end == 0 ? 1 : -1;
    const Eigen::Vector3d& along = joint.axis[0];
    return base * (drawn + (sign * *length - drawn.dot(along)) * along);
  }

  /// The body at the other end of `joint`, so that the joint's points meet (or stand as far apart
  /// as driven or as long).
  Pose placed(const Joint& joint, std::size_t end) const {
    const PointOf& here = joint.at[end];
    const PointOf& there = joint.at[1 - end];
    const bool is_planar = mechanism_.space == Space::planar;
    Pose pose;
    pose.is_placed = true;
    pose.R = is_planar ? planar_orientation(joint, end, there.body)
                       : spatial_orientation(joint, end, there.body);
    const Eigen::Vector3d gap = is_drawn_ && traits(joint.type).place != JointPlace::at_point
                                    ? drawn_gap(joint, end)
                                    : gap_along_line(joint, end, pose.R);
    pose.r = poses_[here.body].r + poses_[here.body].R * point(here) + gap - pose.R * point(there);
    const char* names[] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) pose.r[k] = guess(there.body, names[k]).value_or(pose.r[k]);
    return pose;
  }

  const Mechanism& mechanism_;
  double t_;
  bool is_drawn_;
  std::vector<Pose> poses_;
};

void write_pose(const Pose& pose, Space space, double* q) {
  q[0] = pose.r.x();
  q[1] = pose.r.y();
  if (space == Space::planar) {
    q[2] = std::atan2(pose.R(1, 0), pose.R(0, 0));
    return;
  }
  const Eigen::AngleAxisd turn(pose.R);
  const Eigen::Vector3d v = turn.angle() * turn.axis();
  q[2] = pose.r.z();
  for (int k = 0; k < 3; ++k) q[3 + k] = v[k];
}

}  // namespace

Eigen::VectorXd initial_guess(const Mechanism& mechanism, double t) {
  require_form(mechanism);
  require_drivers(mechanism, t);
  const std::vector<Coordinate> names = coordinates(mechanism);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(names.size()));
  if (is_typed(mechanism)) {
    for (const Driver& driver : mechanism.drivers) {
      q[static_cast<Eigen::Index>(driver.unknown)] = driver_state(driver.law, t).value;
    }
  } else if (!mechanism.guess.empty() || !is_drawn_at(mechanism, t)) {
    const std::vector<Pose> poses = Placement(mechanism, t).place_all();
    const std::size_t size = mechanism.space == Space::planar ? 3 : 6;
    for (std::size_t body = 1; body < poses.size(); ++body) {
      write_pose(poses[body], mechanism.space, q.data() + size * (body - 1));
    }
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto found = mechanism.guess.find(names[k].name);
    if (found != mechanism.guess.end()) q[static_cast<Eigen::Index>(k)] = found->second;
  }
  return q;
}

}  // namespace moivre
