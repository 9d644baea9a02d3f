// SPDX-License-Identifier: MIT
// Pins as trees of revolute joints over points, turned into stars.
#include "shared_pins.h"

#include <algorithm>
#include <set>

namespace moivre {
namespace {

struct Pin {
  std::vector<PointOf> points;
  std::vector<std::size_t> joints;
};

bool is_same(PointOf a, PointOf b) { return a.body == b.body && a.point == b.point; }

bool holds(const Pin& pin, PointOf point) {
  return std::any_of(pin.points.begin(), pin.points.end(),
                     [point](PointOf other) { return is_same(point, other); });
}

/// Adds to the pin what its points are joined to, until nothing is new.
void grow(Pin& pin, const std::vector<Joint>& joints, std::vector<bool>& is_taken) {
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const auto& at = joints[k].at;
      if (is_taken[k] || joints[k].type != JointType::revolute) continue;
      if (!holds(pin, at[0]) && !holds(pin, at[1])) continue;
      for (const PointOf point : at) {
        if (!holds(pin, point)) pin.points.push_back(point);
      }
      pin.joints.push_back(k);
      is_taken[k] = true;
      has_grown = true;
    }
  }
}

std::vector<Pin> pins_of(const Mechanism& mechanism) {
  std::vector<Pin> pins;
  std::vector<bool> is_taken(mechanism.joints.size());
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    const Joint& joint = mechanism.joints[k];
    if (is_taken[k] || joint.type != JointType::revolute) continue;
    pins.push_back({{joint.at[0]}, {}});
    grow(pins.back(), mechanism.joints, is_taken);
  }
  return pins;
}

/// A tree over three points or more, each of a body of its own.
bool is_shared_tree(const Pin& pin) {
  constexpr std::size_t kShared = 3;
  std::set<std::size_t> bodies;
  for (const PointOf point : pin.points) bodies.insert(point.body);
  return pin.points.size() >= kShared && bodies.size() == pin.points.size() &&
         pin.joints.size() + 1 == pin.points.size();
}

/// Every joint of the pin leads from the centre to the end of it that is farther from the centre.
void make_star(const Pin& pin, PointOf centre, JointEnds& ends) {
  Pin reached{{centre}, {}};
  std::vector<std::size_t> left = pin.joints;
  while (!left.empty()) {
    const auto next = std::find_if(left.begin(), left.end(), [&](std::size_t k) {
      return holds(reached, ends[k][0]) || holds(reached, ends[k][1]);
    });
    const std::array<PointOf, 2> at = ends[*next];
    const PointOf farther = holds(reached, at[0]) ? at[1] : at[0];
    ends[*next] = {centre, farther};
    reached.points.push_back(farther);
    left.erase(next);
  }
}

}  // namespace

bool has_shared_pins(const Mechanism& mechanism) {
  const std::vector<Pin> pins = pins_of(mechanism);
  return std::any_of(pins.begin(), pins.end(), is_shared_tree);
}

JointEnds typed_ends(const Mechanism& mechanism) {
  JointEnds ends;
  for (const Joint& joint : mechanism.joints) ends.push_back({joint.at[0], joint.at[1]});
  return ends;
}

JointEnds star_ends(const Mechanism& mechanism, const std::function<std::size_t(PointOf)>& rank) {
  JointEnds ends = typed_ends(mechanism);
  for (const Pin& pin : pins_of(mechanism)) {
    if (!is_shared_tree(pin)) continue;
    const auto centre = std::min_element(pin.points.begin(), pin.points.end(),
                                         [&](PointOf a, PointOf b) { return rank(a) < rank(b); });
    make_star(pin, *centre, ends);
  }
  return ends;
}

}  // namespace moivre
