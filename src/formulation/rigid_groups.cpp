// SPDX-License-Identifier: MIT
// Bodies joined one by one, each with its exact pose in its group.
#include "rigid_groups.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "moivre/formulation/exact.h"
#include "moivre/mechanism/driven_joint.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

// Joints that are held twice agree to rounding of their numbers, or they contradict each other.
constexpr double kSame = 1e-9;

/// About and along the joint's axis.
ExactPose driven_motion(const DrivenJoint& driven) {
  ExactPose motion = ExactPose::identity();
  if (driven.angle) motion = turn_about_z(*driven.angle);
  if (driven.slide) motion = motion * shift_to({0, 0, *driven.slide});
  return motion;
}

/// Whether two poses are one, lengths relative to `size`.
bool is_same(const ExactPose& a, const ExactPose& b) {
  const DualQuaternion<double> apart = to_double(conjugate(a) * b);
  const double size = std::sqrt(dot(apart.q, apart.q));
  const double turn = std::hypot(apart.q[1], apart.q[2], apart.q[3]);
  const double shift = std::sqrt(dot(apart.g, apart.g));
  const DualQuaternion<double> from = to_double(a);
  const double far = std::sqrt(dot(from.g, from.g) / dot(from.q, from.q));
  return turn <= kSame * size && shift <= kSame * size * std::max(1.0, far);
}

class Grouping {
 public:
  Grouping(const Mechanism& mechanism, double t) : mechanism_(mechanism), t_(t) {
    for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
      root_.push_back(body);
      pose_.push_back(ExactPose::identity());
    }
  }

  RigidGroups run() && {
    std::vector<std::size_t> free;
    for (std::size_t k = 0; k < mechanism_.joints.size(); ++k) {
      const auto motion = known_motion(mechanism_.joints[k], driven_joint(mechanism_, k, t_));
      if (motion) {
        join(mechanism_.joints[k], *motion);
      } else {
        free.push_back(k);
      }
    }
    number_groups();
    note_rounding();
    for (const std::size_t k : free) tie(mechanism_.joints[k], driven_joint(mechanism_, k, t_));
    add_driven_points();
    return std::move(groups_);
  }

 private:
  /// The joint's frame in its body number k.
  ExactPose end(const Joint& joint, std::size_t k) const {
    const PointOf& at = joint.at[k];
    ExactPose frame = shift_to(mechanism_.bodies[at.body].points[at.point].at);
    if (axis_count(joint.type) == 0) return frame;
    frame = frame * frame_of(joint.axis[k]);
    return k == 0 ? frame * turn_about_z(joint.turn_rad) : frame;
  }

  /// M where nothing of it is left free.
  std::optional<ExactPose> known_motion(const Joint& joint, const DrivenJoint& driven) const {
    const JointTraits& type = traits(joint.type);
    const bool stands = type.place == JointPlace::at_point || (has_line(type.type) && driven.slide);
    const bool keeps_turn = type.turn == JointTurn::not_at_all || driven.angle;
    if (!stands || !keeps_turn) return std::nullopt;
    return driven_motion(driven);
  }

  void join(const Joint& joint, const ExactPose& motion) {
    const std::size_t a = joint.at[0].body;
    const std::size_t b = joint.at[1].body;
    const ExactPose there = pose_[a] * end(joint, 0) * motion * conjugate(end(joint, 1));
    const std::size_t from = root_[b];
    const std::size_t to = root_[a];
    if (from == to) {
      const std::string label = to_string(joint.type) + " " + joint.name;
      if (is_same(there, pose_[b])) {
        groups_.left_out.emplace_back(label, "its bodies are already held in the same pose");
      } else {
        groups_.contradictions.push_back(label + " holds bodies that are already held otherwise");
      }
      return;
    }
    // Bodies of the later group move to the earlier one's frame: the ground stays what it is.
    const ExactPose between = there * conjugate(pose_[b]);  // frame of `from` in that of `to`
    const bool is_kept = to < from;
    const ExactPose moved = is_kept ? between : conjugate(between);
    const std::size_t lost = is_kept ? from : to;
    const std::size_t kept = is_kept ? to : from;
    for (std::size_t body = 0; body < root_.size(); ++body) {
      if (root_[body] != lost) continue;
      root_[body] = kept;
      pose_[body] = moved * pose_[body];
    }
  }

  /// An actuator is a rod of the driven length, or nothing.
  void tie(const Joint& joint, const DrivenJoint& driven) {
    const JointTraits& type = traits(joint.type);
    const bool is_actuator = type.place == JointPlace::at_any_distance;
    if (is_actuator && !driven.slide) return;
    if (type.turn == JointTurn::by_thread && !driven.angle) {
      throw InvalidInput(
          "the screw '" + joint.name +
          "' ties an angle to a length, which no polynomial says; drive it (slide = \"" +
          joint.name + "\"), or follow one pose with `follow_guesses`");
    }
    Tie tie;
    tie.name = joint.name;
    tie.i = groups_.group_of[joint.at[0].body];
    tie.j = groups_.group_of[joint.at[1].body];
    tie.at_i = pose_[joint.at[0].body] * end(joint, 0);
    tie.at_j = pose_[joint.at[1].body] * end(joint, 1);
    tie.place = type.place;
    tie.turn = driven.angle ? JointTurn::not_at_all : type.turn;
    if (is_actuator) {
      tie.place = JointPlace::at_distance;
      tie.square = signed_square(*driven.slide);
    } else {
      tie.at_i = tie.at_i * driven_motion(driven);
      if (driven.slide) tie.place = JointPlace::at_point;
      if (is_rod(tie)) tie.square = signed_square(joint.length);
    }
    groups_.ties.push_back(std::move(tie));
  }

  /// A turn is a fraction where it is none.
  void note_rounding() {
    const auto is_exact = [&](std::size_t k) {
      const Joint& joint = mechanism_.joints[k];
      const int axes = axis_count(joint.type);
      const bool is_turned = axes > 0 && joint.turn_rad != 0;
      return !is_turned && driven_joint(mechanism_, k, t_).angle.value_or(0) == 0 &&
             std::all_of(joint.axis.begin(), joint.axis.begin() + (axes > 0 ? 2 : 0),
                         has_exact_frame);
    };
    for (std::size_t k = 0; k < mechanism_.joints.size(); ++k) {
      groups_.has_exact_frames = groups_.has_exact_frames && is_exact(k);
    }
  }

  void number_groups() {
    std::vector<std::size_t> number(root_.size());
    for (std::size_t body = 0; body < root_.size(); ++body) {
      if (root_[body] == body) {
        number[body] = groups_.names.size();
        groups_.names.push_back(mechanism_.bodies[body].name);
        groups_.bodies.emplace_back();
      }
      groups_.group_of.push_back(number[root_[body]]);
      groups_.bodies[groups_.group_of.back()].push_back(mechanism_.bodies[body].name);
    }
    groups_.in_group = pose_;
    groups_.is_left_out.assign(groups_.names.size(), false);
  }

  void add_driven_points() {
    for (const Driver& driver : mechanism_.drivers) {
      constexpr std::array<DriverKind, 3> kAxes{DriverKind::x, DriverKind::y, DriverKind::z};
      const auto axis = std::find(kAxes.begin(), kAxes.end(), driver.kind);
      if (axis == kAxes.end()) continue;
      const std::size_t body = driver.point.body;
      const auto& point = mechanism_.bodies[body].points[driver.point.point];
      groups_.driven_points.push_back({driver.name, groups_.group_of[body],
                                       pose_[body] * shift_to(point.at),
                                       static_cast<std::size_t>(axis - kAxes.begin()),
                                       typed_decimal(driver_state(driver.law, t_).value)});
    }
  }

  const Mechanism& mechanism_;
  double t_;
  std::vector<std::size_t> root_;  ///< of each body: the first body of its group
  std::vector<ExactPose> pose_;    ///< of each body in that one's frame
  RigidGroups groups_;
};

}  // namespace

std::size_t freedom(const Tie& tie) {
  constexpr int kRigidBody = 6;
  if (is_meeting(tie)) return kRigidBody - 1;
  return static_cast<std::size_t>(kRigidBody - row_count(tie.place, Space::spatial) -
                                  row_count(tie.turn, Space::spatial));
}

std::size_t turn_freedom(const Tie& tie) {
  constexpr int kFreeTurns = 3;
  return static_cast<std::size_t>(kFreeTurns - row_count(tie.turn, Space::spatial));
}

bool is_rod(const Tie& tie) { return tie.place == JointPlace::at_distance; }

bool is_meeting(const Tie& tie) { return tie.place == JointPlace::anywhere; }

bool is_loose(const Tie& tie) {
  constexpr std::size_t kAllButOne = 5;
  return freedom(tie) == kAllButOne;
}

Tie reversed(const Tie& tie) {
  Tie other = tie;
  std::swap(other.i, other.j);
  std::swap(other.at_i, other.at_j);
  other.is_reversed = !tie.is_reversed;
  return other;
}

RigidGroups rigid_groups(const Mechanism& mechanism, double t) {
  return Grouping(mechanism, t).run();
}

}  // namespace moivre
