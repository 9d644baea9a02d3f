// SPDX-License-Identifier: MIT
// Bodies joined to groups that do not turn apart, the groups that hang between two balls, and those
// whose joints share an axis.
#include "moivre/mechanism/spins.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <optional>

#include "moivre/mechanism/joint_type.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

// Axes that miss each other by this part of the distance of their points are meant to be one, or by
// what rounding leaves of coordinates.
constexpr double kMeet = 1e-11;
constexpr double kRounding = 1e-15;

/// One end of a joint.
struct End {
  std::size_t joint = 0;
  std::size_t number = 0;  ///< 0: the joint's first body
};

class SpinFinder {
 public:
  explicit SpinFinder(const Mechanism& mechanism)
      : mechanism_(mechanism), group_(mechanism.bodies.size()) {
    std::iota(group_.begin(), group_.end(), std::size_t{0});
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
      const Joint& joint = mechanism.joints[k];
      if (is_rigid(k))
        std::replace(group_.begin(), group_.end(), group_of(joint.at[1]), group_of(joint.at[0]));
    }
  }

  std::vector<Spin> find() const {
    std::vector<Spin> spins;
    for (std::size_t body = 1; body < group_.size(); ++body) {
      if (!is_first_of_group(body) || has_driven_point(group_[body])) continue;
      if (const auto line = line_of(group_[body])) spins.push_back({body, *line});
    }
    return spins;
  }

  std::vector<IdleTurn> idle_turns() const {
    std::vector<IdleTurn> turns;
    for (std::size_t body = 1; body < group_.size(); ++body) {
      const std::size_t group = group_[body];
      if (group == group_[0] || !is_first_of_group(body) || has_driven_point(group)) continue;
      const std::vector<End> ends = ends_at(group);
      const auto turning = std::find_if(ends.begin(), ends.end(), [&](const End& end) {
        return ends.size() > 1 && turns_idly(end, ends);
      });
      if (turning != ends.end()) turns.push_back({body, turning->joint});
    }
    return turns;
  }

 private:
  std::size_t group_of(const PointOf& at) const { return group_[at.body]; }

  bool is_first_of_group(std::size_t body) const {
    return std::find(group_.begin(), group_.end(), group_[body]) ==
           group_.begin() + static_cast<std::ptrdiff_t>(body);
  }

  bool is_driven(std::size_t joint, DriverKind kind) const {
    return std::any_of(
        mechanism_.drivers.begin(), mechanism_.drivers.end(),
        [&](const Driver& driver) { return driver.kind == kind && driver.joint == joint; });
  }

  /// Whether the joint leaves nothing free while the drivers stand.
  bool is_rigid(std::size_t number) const {
    const Joint& joint = mechanism_.joints[number];
    const JointTraits& type = traits(joint.type);
    const bool is_threaded = type.turn == JointTurn::by_thread;
    const bool has_angle = is_driven(number, DriverKind::angle);
    const bool has_slide = is_driven(number, DriverKind::slide);
    const bool stands =
        type.place == JointPlace::at_point ||
        (type.place == JointPlace::on_line && (has_slide || (is_threaded && has_angle)));
    return stands &&
           (type.turn == JointTurn::not_at_all || has_angle || (is_threaded && has_slide));
  }

  bool has_driven_point(std::size_t group) const {
    return std::any_of(
        mechanism_.drivers.begin(), mechanism_.drivers.end(), [&](const Driver& driver) {
          const bool is_of_point = driver.kind == DriverKind::x || driver.kind == DriverKind::y ||
                                   driver.kind == DriverKind::z;
          return is_of_point && group_of(driver.point) == group;
        });
  }

  /// The joints' ends that tie the group to others; limits of a slide do so too.
  std::vector<End> ends_at(std::size_t group) const {
    std::vector<End> ends;
    for (std::size_t k = 0; k < mechanism_.joints.size(); ++k) {
      const Joint& joint = mechanism_.joints[k];
      if (group_of(joint.at[0]) == group_of(joint.at[1])) continue;
      const bool holds =
          has_rows(joint.type, Space::spatial) || joint.limits || is_driven(k, DriverKind::slide);
      if (!holds) continue;
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        if (group_of(joint.at[end]) == group) ends.push_back({k, end});
      }
    }
    return ends;
  }

  /// The points of the two balls that alone tie the group to two others.
  std::optional<std::array<PointOf, 2>> line_of(std::size_t group) const {
    const std::vector<End> ends = ends_at(group);
    if (ends.size() != 2) return std::nullopt;
    std::array<PointOf, 2> balls;
    std::array<std::size_t, 2> others{};
    for (std::size_t k = 0; k < 2; ++k) {
      const Joint& joint = mechanism_.joints[ends[k].joint];
      if (joint.type != JointType::spherical) return std::nullopt;
      balls[k] = joint.at[ends[k].number];
      others[k] = group_of(joint.at[1 - ends[k].number]);
    }
    if (others[0] == others[1] || is_one_point(balls[0], balls[1])) return std::nullopt;
    return balls;
  }

  /// Whether the bodies turn about this joint's axis, and all others at these ends let them.
  bool turns_idly(const End& end, const std::vector<End>& ends) const {
    const Joint& joint = mechanism_.joints[end.joint];
    const bool is_hinge = traits(joint.type).turn == JointTurn::about_axis &&
                          traits(joint.type).place != JointPlace::in_plane;
    return is_hinge && std::all_of(ends.begin(), ends.end(), [&](const End& other) {
             return lets_turn(other, joint.at[end.number], joint.axis[end.number]);
           });
  }

  /// Whether the joint is the same for a body that has turned about this line of it. In another
  /// body of the group it is not asked.
  bool lets_turn(const End& end, const PointOf& at, const Eigen::Vector3d& along) const {
    const Joint& joint = mechanism_.joints[end.joint];
    const PointOf& point = joint.at[end.number];
    if (point.body != at.body) return false;
    const Eigen::Vector3d& from = mechanism_.bodies[at.body].points[at.point].at;
    const Eigen::Vector3d& to = mechanism_.bodies[at.body].points[point.point].at;
    const double noise = kMeet * (to - from).norm() + kRounding * std::max(from.norm(), to.norm());
    const bool is_on_line = (to - from).cross(along).norm() <= noise;
    const JointTraits& type = traits(joint.type);
    const bool is_point =
        type.turn == JointTurn::freely && (axis_count(joint.type) == 0 || end.number == 1);
    if (is_point) return is_on_line;
    const bool turns =
        type.turn == JointTurn::freely ||
        (type.turn == JointTurn::about_axis && !is_driven(end.joint, DriverKind::angle) &&
         !(is_angular(joint.type) && joint.limits));
    const bool is_parallel = joint.axis[end.number].cross(along).norm() <= kMeet;
    return turns && is_parallel && (is_on_line || type.place == JointPlace::in_plane);
  }

  bool is_one_point(const PointOf& a, const PointOf& b) const {
    return a.body == b.body && mechanism_.bodies[a.body].points[a.point].at ==
                                   mechanism_.bodies[b.body].points[b.point].at;
  }

  const Mechanism& mechanism_;
  std::vector<std::size_t> group_;  ///< of each body
};

/// Whether a planar joint stays what it is while the body turns about this pin of it.
bool lets_turn_in_plane(const Mechanism& mechanism, const Joint& joint, const PointOf& pin) {
  const bool is_pinned = (joint.type == JointType::revolute && !joint.limits) ||
                         joint.type == JointType::rod || joint.type == JointType::actuator ||
                         (joint.type == JointType::slot && joint.at[1].body == pin.body);
  const PointOf& own = joint.at[joint.at[0].body == pin.body ? 0 : 1];
  const auto& points = mechanism.bodies[pin.body].points;
  return is_pinned && points[own.point].at == points[pin.point].at;
}

/// Of the joints that touch the body, a revolute one about whose pin all let it turn.
std::optional<std::size_t> planar_idle_joint(const Mechanism& mechanism, std::size_t body) {
  const auto& joints = mechanism.joints;
  const auto touches = [&](const std::vector<std::size_t>& bodies) {
    return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
  };
  const bool is_driven =
      std::any_of(mechanism.drivers.begin(), mechanism.drivers.end(),
                  [&](const Driver& driver) { return touches(bodies_of(mechanism, driver)); });
  const auto hinge = std::find_if(joints.begin(), joints.end(), [&](const Joint& joint) {
    return joint.type == JointType::revolute && touches(bodies_of(joint));
  });
  if (is_driven || hinge == joints.end()) return std::nullopt;
  const PointOf& pin = hinge->at[hinge->at[0].body == body ? 0 : 1];
  const bool turns = std::all_of(joints.begin(), joints.end(), [&](const Joint& joint) {
    return !touches(bodies_of(joint)) || lets_turn_in_plane(mechanism, joint, pin);
  });
  if (!turns) return std::nullopt;
  return static_cast<std::size_t>(hinge - joints.begin());
}

std::vector<IdleTurn> planar_idle_turns(const Mechanism& mechanism) {
  std::vector<IdleTurn> turns;
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    if (const auto joint = planar_idle_joint(mechanism, body)) turns.push_back({body, *joint});
  }
  return turns;
}

}  // namespace

std::vector<Spin> find_spins(const Mechanism& mechanism) {
  if (is_typed(mechanism) || mechanism.space == Space::planar) return {};
  return SpinFinder(mechanism).find();
}

std::vector<IdleTurn> find_idle_turns(const Mechanism& mechanism) {
  if (is_typed(mechanism)) return {};
  if (mechanism.space == Space::planar) return planar_idle_turns(mechanism);
  return SpinFinder(mechanism).idle_turns();
}

bool are_spins_as_meant(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  const Eigen::Vector3d mark = spin_mark();
  return std::all_of(
      mechanism.held_spins.begin(), mechanism.held_spins.end(), [&](const Spin& spin) {
        const Eigen::Vector3d line =
            point_position(mechanism, spin.line[1], q) - point_position(mechanism, spin.line[0], q);
        const Eigen::Vector3d turned = orientation(mechanism, spin.body, q) * mark;
        return line.cross(turned).dot(line.cross(mark)) > 0;
      });
}

Eigen::Vector3d spin_mark() { return Eigen::Vector3d(0.3183, 0.2718, 0.9081).normalized(); }

}  // namespace moivre
