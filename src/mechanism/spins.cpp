// SPDX-License-Identifier: MIT
// Bodies joined to groups that do not turn apart, and the groups that hang between two balls.
#include "moivre/mechanism/spins.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <optional>

#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

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
      const bool is_first = std::find(group_.begin(), group_.end(), group_[body]) ==
                            group_.begin() + static_cast<std::ptrdiff_t>(body);
      if (!is_first || has_driven_point(group_[body])) continue;
      if (const auto line = line_of(group_[body])) spins.push_back({body, *line});
    }
    return spins;
  }

 private:
  std::size_t group_of(const PointOf& at) const { return group_[at.body]; }

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

  /// The points of the two balls that alone tie the group to two others.
  std::optional<std::array<PointOf, 2>> line_of(std::size_t group) const {
    std::vector<PointOf> balls;
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < mechanism_.joints.size(); ++k) {
      const Joint& joint = mechanism_.joints[k];
      if (group_of(joint.at[0]) == group_of(joint.at[1])) continue;
      const bool holds = has_rows(joint.type, Space::spatial) || is_driven(k, DriverKind::slide);
      if (!holds) continue;
      for (const std::size_t end : {0U, 1U}) {
        if (group_of(joint.at[end]) != group) continue;
        if (joint.type != JointType::spherical) return std::nullopt;
        balls.push_back(joint.at[end]);
        others.push_back(group_of(joint.at[1 - end]));
      }
    }
    if (balls.size() != 2 || others[0] == others[1] || is_one_point(balls[0], balls[1]))
      return std::nullopt;
    return std::array{balls[0], balls[1]};
  }

  bool is_one_point(const PointOf& a, const PointOf& b) const {
    return a.body == b.body && mechanism_.bodies[a.body].points[a.point].at ==
                                   mechanism_.bodies[b.body].points[b.point].at;
  }

  const Mechanism& mechanism_;
  std::vector<std::size_t> group_;  ///< of each body
};

}  // namespace

std::vector<Spin> find_spins(const Mechanism& mechanism) {
  if (is_typed(mechanism) || mechanism.space == Space::planar) return {};
  return SpinFinder(mechanism).find();
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
