// SPDX-License-Identifier: MIT
// Has each joint the ends, directions and numbers that its type needs?
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <string_view>

#include "faults.h"
#include "moivre/mechanism/joint_type.h"

namespace moivre {
namespace {

/// The joint, and where its faults go.
struct Checked {
  const Mechanism& mechanism;
  const Joint& joint;
  Faults& faults;

  void fault(const std::string& rule) const {
    faults.push_back({joint.where, to_string(joint.type) + " joint '" + joint.name + "' " + rule});
  }
  void require(bool is_right, const char* rule) const {
    if (!is_right) fault(rule);
  }
};

/// False where a body or a point is not there.
bool check_ends(const Checked& at) {
  const auto& bodies = at.mechanism.bodies;
  const bool has_points = traits(at.joint.type).place != JointPlace::anywhere;
  bool is_whole = true;
  for (const PointOf& end : at.joint.at) {
    if (end.body >= bodies.size()) {
      at.fault("names body " + std::to_string(end.body) + ", counted from 0, of " +
               std::to_string(bodies.size()));
      is_whole = false;
    } else if (has_points && end.point >= bodies[end.body].points.size()) {
      at.fault("names point " + std::to_string(end.point) + ", counted from 0, of body '" +
               bodies[end.body].name + "', which has " +
               std::to_string(bodies[end.body].points.size()));
      is_whole = false;
    }
  }
  if (is_whole && at.joint.at[0].body == at.joint.at[1].body) {
    at.fault("ties body '" + bodies[at.joint.at[0].body].name + "' to itself");
  }
  return is_whole;
}

bool is_unit(const Eigen::Vector3d& axis) {
  constexpr double kRounding = 1e-12;
  return axis.allFinite() && std::abs(axis.norm() - 1) <= kRounding;
}

void check_axes(const Checked& at) {
  const bool is_planar = at.mechanism.space == Space::planar;
  const int read = is_planar ? (has_line(at.joint.type) ? 1 : 0) : axis_count(at.joint.type);
  for (int k = 0; k < read; ++k) {
    const Eigen::Vector3d& axis = at.joint.axis[static_cast<std::size_t>(k)];
    const auto name = [&] { return "axis[" + std::to_string(k) + "]"; };
    if (!is_unit(axis)) at.fault("needs " + name() + " of length 1");
    if (is_planar && axis.z() != 0) at.fault("is planar: " + name() + " must have z = 0");
  }
}

void check_lengths(const Checked& at) {
  const Joint& joint = at.joint;
  if (joint.type == JointType::rod) {
    at.require(is_workable(joint.length), "needs a finite length");
  } else if (joint.type == JointType::actuator) {
    at.require(joint.length >= 0 && is_workable(joint.length), "needs a finite length from 0");
  }
  if (joint.type == JointType::rack) {
    at.require(joint.radius != 0 && is_workable(joint.radius),
               "needs a finite radius other than 0");
  }
  if (joint.type == JointType::screw) {
    at.require(joint.pitch != 0 && is_workable(joint.pitch), "needs a finite pitch other than 0");
  }
  at.require(is_workable_angle(joint.turn_rad), "needs a finite turn, at most a million turns");
}

/// What a joint's type does not read is a number all the same: whatever looks through all joints
/// meets it.
void check_unread(const Checked& at) {
  const Joint& joint = at.joint;
  const double numbers[] = {joint.length,         joint.radius,        joint.pitch,
                            joint.gear.phase_rad, joint.gear.radii[0], joint.gear.radii[1]};
  const bool are_finite = std::all_of(std::begin(numbers), std::end(numbers), is_workable) &&
                          joint.axis[0].allFinite() && joint.axis[1].allFinite();
  at.require(are_finite, "has a number that is not finite, or beyond 1e50");
}

void check_limits(const Checked& at) {
  if (!at.joint.limits) return;
  const Limits& limits = *at.joint.limits;
  const bool is_finite = is_workable(limits.lower) && is_workable(limits.upper);
  at.require(is_finite, "needs finite limits");
  at.require(!is_finite || limits.lower <= limits.upper, "has its lower limit above the upper");
  at.require(at.joint.type != JointType::actuator || !(limits.lower < 0),
             "has a length: its limits are from 0 up");
}

bool is_whole_turn(const Spline& profile) {
  constexpr std::size_t kFewest = 4;
  constexpr double kRounding = 1e-9;
  const std::size_t rows = profile.t.size();
  if (rows < kFewest || profile.value.size() != rows || profile.curvature.size() != rows) {
    return false;
  }
  const auto all_finite = [](const std::vector<double>& x) {
    return std::all_of(x.begin(), x.end(), is_workable);
  };
  const bool increases =
      std::adjacent_find(profile.t.begin(), profile.t.end(),
                         [](double a, double b) { return !(a < b); }) == profile.t.end();
  return all_finite(profile.t) && all_finite(profile.value) && all_finite(profile.curvature) &&
         increases &&
         std::abs(profile.t.back() - profile.t.front() - 2 * std::numbers::pi) <= kRounding;
}

void check_transmission(const Checked& at) {
  const Gear& gear = at.joint.gear;
  // Whatever copies a joint renumbers its carrier, read or not.
  if (gear.carrier >= at.mechanism.bodies.size()) {
    at.fault("names carrier " + std::to_string(gear.carrier) + ", counted from 0, of " +
             std::to_string(at.mechanism.bodies.size()) + " bodies");
  }
  if (!is_transmission(at.joint.type)) return;
  const auto is_wheel = [](int teeth) { return teeth != 0 && std::abs(teeth) <= kMostTeeth; };
  at.require(is_wheel(gear.teeth[0]) && is_wheel(gear.teeth[1]),
             "needs teeth other than 0, at most 100000");
  at.require(is_workable_angle(gear.phase_rad), "needs a finite phase, at most a million turns");
  if (at.joint.type == JointType::belt) {
    at.require(gear.radii[0] > 0 && gear.radii[1] > 0 && is_workable(gear.radii[0]) &&
                   is_workable(gear.radii[1]),
               "needs two finite radii above 0");
  }
  const bool is_third = gear.carrier == 0 || (gear.carrier != at.joint.at[0].body &&
                                              gear.carrier != at.joint.at[1].body);
  at.require(is_third, "needs a third body as its carrier");
  if (traits(at.joint.type).turn == JointTurn::by_cam) {
    at.require(is_whole_turn(at.joint.profile),
               "needs a profile of four or more angles that increase over a whole turn "
               "(periodic_spline makes it)");
  }
}

}  // namespace

void find_joint_faults(const Mechanism& mechanism, Faults& faults) {
  std::set<std::string_view> taken;
  for (const Joint& joint : mechanism.joints) {
    const Checked at{mechanism, joint, faults};
    if (joint.name.empty()) at.fault("has no name");
    if (!joint.name.empty() && !taken.insert(joint.name).second) {
      faults.push_back({joint.where, "two joints are called '" + joint.name + "'"});
    }
    if (!exists_in(mechanism.space, traits(joint.type))) {
      at.fault(mechanism.space == Space::planar ? "exists in spatial mechanisms only"
                                                : "exists in planar mechanisms only");
      continue;
    }
    if (!check_ends(at)) continue;
    check_axes(at);
    check_lengths(at);
    check_unread(at);
    check_limits(at);
    check_transmission(at);
  }
}

}  // namespace moivre
