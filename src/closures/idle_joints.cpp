// SPDX-License-Identifier: MIT
// Bodies in groups that nothing moves apart, and joints that alone tie a group to the others.
#include "moivre/closures/idle_joints.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "closure_sentences.h"
#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/spins.h"

namespace moivre {
namespace {

using Joints = std::vector<std::size_t>;

class Holding {
 public:
  explicit Holding(const Mechanism& mechanism)
      : held_{mechanism, {}}, group_(mechanism.bodies.size()) {
    std::iota(group_.begin(), group_.end(), std::size_t{0});
    for (const Joint& joint : mechanism.joints) {
      if (joint.type == JointType::weld) merge(joint);
    }
  }

  HeldMechanism run() && {
    while (hold_next() || hold_next_turn()) {
    }
    return std::move(held_);
  }

  /// Whether something is left that moves apart from the ground.
  bool is_whole_held() const {
    return std::all_of(group_.begin(), group_.end(),
                       [&](std::size_t group) { return group == group_[0]; });
  }

 private:
  bool hold_next() {
    for (std::size_t body = 1; body < group_.size(); ++body) {
      const std::size_t group = group_[body];
      if (group == group_[0] || !is_idle(group)) continue;
      hold(ties(group).front(), group);
      return true;
    }
    return false;
  }

  /// Of a joint that may turn as it likes (mechanism/spins.h).
  bool hold_next_turn() {
    const std::vector<IdleTurn> turns = find_idle_turns(held_.mechanism);
    if (turns.empty()) return false;
    // Hinges first: what is held by one may let its neighbour turn, what only slides does not.
    const auto hinge = std::find_if(turns.begin(), turns.end(), [&](const IdleTurn& turn) {
      return held_.mechanism.joints[turn.joint].type == JointType::revolute;
    });
    if (hinge != turns.end()) {
      hold(hinge->joint, group_[hinge->body]);
      return true;
    }
    Joint& joint = held_.mechanism.joints[turns.front().joint];
    joint.type = JointType::prismatic;
    const std::size_t end = group_of(joint.at[0]) == group_[turns.front().body] ? 0 : 1;
    held_.idle.push_back({held_.mechanism.bodies[joint.at[end].body].name, joint.name,
                          pose_text(joint, joint.at[1 - end].body)});
    return true;
  }

  /// Wheels on pivots of their own that mesh like a tree, with no other wheel, no carrier among
  /// them and no driver.
  bool is_idle(std::size_t group) const {
    const std::set<std::size_t> wheels = meshing_with(group);
    if (wheels.count(group_[0]) > 0 || is_driven(wheels)) return false;
    std::size_t gears = 0;
    for (const Joint& joint : held_.mechanism.joints) {
      if (!is_transmission(joint.type) || is_inside(joint)) continue;
      if (wheels.count(group_[joint.gear.carrier]) > 0) return false;
      gears += wheels.count(group_of(joint.at[0]));
    }
    return gears + 1 == wheels.size() &&
           std::all_of(wheels.begin(), wheels.end(),
                       [&](std::size_t wheel) { return ties(wheel).size() == 1; });
  }

  bool is_driven(const std::set<std::size_t>& groups) const {
    const auto& mechanism = held_.mechanism;
    return std::any_of(
        mechanism.drivers.begin(), mechanism.drivers.end(), [&](const Driver& driver) {
          const std::vector<std::size_t> bodies = bodies_of(mechanism, driver);
          return std::any_of(bodies.begin(), bodies.end(),
                             [&](std::size_t body) { return groups.count(group_[body]) > 0; });
        });
  }

  /// The groups whose wheels mesh with this one's, and so on.
  std::set<std::size_t> meshing_with(std::size_t group) const {
    std::set<std::size_t> all{group};
    for (bool has_grown = true; has_grown;) {
      const std::size_t before = all.size();
      for (const Joint& joint : held_.mechanism.joints) {
        if (!is_transmission(joint.type) || is_inside(joint)) continue;
        const std::size_t wheels[] = {group_of(joint.at[0]), group_of(joint.at[1])};
        if (all.count(wheels[0]) > 0 || all.count(wheels[1]) > 0) all.insert(wheels, wheels + 2);
      }
      has_grown = all.size() > before;
    }
    return all;
  }

  /// Joints that hold the group to others; gears tie angles, not places.
  Joints ties(std::size_t group) const {
    Joints found;
    const auto& joints = held_.mechanism.joints;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const bool is_within = group_of(joints[k].at[0]) == group_of(joints[k].at[1]);
      const bool holds = row_count(traits(joints[k].type).place, held_.mechanism.space) > 0;
      if (holds && !is_within && touches(joints[k], group)) {
        found.push_back(k);
      }
    }
    return found;
  }

  /// Makes the joint a weld of its two points, or of where the second one slides to or stands at
  /// the rod's end.
  void hold(std::size_t number, std::size_t group) {
    Joint& joint = held_.mechanism.joints[number];
    const std::size_t end = group_of(joint.at[0]) == group ? 0 : 1;
    const std::size_t body = joint.at[end].body;
    const std::size_t other = joint.at[1 - end].body;
    const bool is_planar = held_.mechanism.space == Space::planar;
    if (is_planar) joint.turn_rad = drawn_angle(joint);
    double apart = joint.type == JointType::rod ? joint.length : 0;
    if (has_line(joint.type) && joint.limits) {
      apart = std::clamp(0.0, joint.limits->lower, joint.limits->upper);
    }
    auto& points = held_.mechanism.bodies[joint.at[0].body].points;
    if (apart != 0) {
      BodyPoint point = points[joint.at[0].point];
      point.at += apart * joint.axis[0];
      point.name += "_" + std::to_string(points.size());  // names of a body's points are different
      joint.at[0].point = points.size();
      points.push_back(std::move(point));
    }
    if (!is_planar) aim(joint);
    joint.type = JointType::weld;
    joint.limits.reset();
    held_.idle.push_back({held_.mechanism.bodies[body].name, joint.name, pose_text(joint, other)});
    merge(joint);
  }

  void merge(const Joint& joint) {
    merge(group_of(joint.at[1]), group_of(joint.at[0]));
    while (merge_meshing()) {
    }
  }

  void merge(std::size_t from, std::size_t to) {
    std::replace(group_.begin(), group_.end(), from, to);
  }

  /// A wheel on a pin of the gear's carrier whose partner cannot turn against that: it cannot
  /// either. False where there is none.
  bool merge_meshing() {
    const auto& joints = held_.mechanism.joints;
    for (const Joint& gear : joints) {
      if (gear.type != JointType::gear && gear.type != JointType::belt) continue;
      const std::size_t carrier = group_[gear.gear.carrier];
      for (const std::size_t end : {0U, 1U}) {
        const std::size_t wheel = group_of(gear.at[1 - end]);
        if (group_of(gear.at[end]) != carrier || wheel == carrier) continue;
        const bool is_pinned = std::any_of(joints.begin(), joints.end(), [&](const Joint& pin) {
          return pin.type == JointType::revolute && touches(pin, wheel) && touches(pin, carrier);
        });
        if (!is_pinned) continue;
        merge(wheel, carrier);
        return true;
      }
    }
    return false;
  }

  /// Axes and angle of the weld that a spatial joint becomes: as drawn where it lets the bodies
  /// turn as they like, else as near to that as it allows.
  static void aim(Joint& joint) {
    const JointTurn turn = traits(joint.type).turn;
    auto& [a, b] = joint.axis;
    if (turn == JointTurn::freely) a = b = Eigen::Vector3d::UnitZ();
    if (turn == JointTurn::about_two_axes) a = perpendicular(a, b);
    if (is_angular(joint.type) && joint.limits) {
      joint.turn_rad = std::clamp(0.0, joint.limits->lower, joint.limits->upper);
    }
  }

  /// The unit vector perpendicular to a that is nearest to b; any where they are parallel.
  static Eigen::Vector3d perpendicular(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d across = b - a.dot(b) * a;
    constexpr double kParallel = 1e-9;
    return (across.norm() > kParallel ? across : Eigen::Vector3d(joint_frame(a).col(0)))
        .normalized();
  }

  double drawn_angle(const Joint& joint) const {
    if (joint.type == JointType::prismatic) return joint.turn_rad;
    const auto guess = [&](std::size_t body) {
      const auto found = held_.mechanism.guess.find(held_.mechanism.bodies[body].name + ".phi");
      return found == held_.mechanism.guess.end() ? 0 : found->second;
    };
    const double angle = guess(joint.at[1].body) - guess(joint.at[0].body);
    const bool has_limits = is_angular(joint.type) && joint.limits;
    return has_limits ? std::clamp(angle, joint.limits->lower, joint.limits->upper) : angle;
  }

  std::string pose_text(const Joint& joint, std::size_t other) const {
    return held_at_angle(joint.turn_rad, held_.mechanism.units.angle,
                         held_.mechanism.bodies[other].name);
  }

  std::size_t group_of(const PointOf& point) const { return group_[point.body]; }
  /// Whether the gear and its carrier are one group.
  bool is_inside(const Joint& gear) const {
    return group_of(gear.at[0]) == group_of(gear.at[1]) &&
           group_of(gear.at[0]) == group_[gear.gear.carrier];
  }
  bool touches(const Joint& joint, std::size_t group) const {
    return group_of(joint.at[0]) == group || group_of(joint.at[1]) == group;
  }

  HeldMechanism held_;
  std::vector<std::size_t> group_;  ///< of each body; the ground's is group_[0]
};

/// The joint that ties this point of a body to another one.
const Joint& ball_at(const Mechanism& mechanism, const PointOf& point) {
  return *std::find_if(mechanism.joints.begin(), mechanism.joints.end(), [&](const Joint& joint) {
    return joint.type == JointType::spherical &&
           std::any_of(joint.at.begin(), joint.at.end(), [&](const PointOf& at) {
             return at.body == point.body && at.point == point.point;
           });
  });
}

void hold_spins(HeldMechanism& held) {
  Mechanism& mechanism = held.mechanism;
  mechanism.held_spins = find_spins(mechanism);
  for (const Spin& spin : mechanism.held_spins) {
    held.idle.push_back({mechanism.bodies[spin.body].name, ball_at(mechanism, spin.line[1]).name,
                         held_in_one_turn()});
  }
}

}  // namespace

HeldMechanism hold_idle(const Mechanism& mechanism) {
  if (is_typed(mechanism)) return {mechanism, {}};
  HeldMechanism held = Holding(mechanism).run();
  if (Holding(held.mechanism).is_whole_held()) held = {mechanism, {}};
  hold_spins(held);
  return held;
}

}  // namespace moivre
