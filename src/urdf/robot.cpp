// SPDX-License-Identifier: MIT
// Names and leaves of a robot.
#include "moivre/urdf/robot.h"

#include <algorithm>

namespace moivre {
namespace {

template <class List>
std::optional<std::size_t> place_of(const List& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const auto& element) { return element.name == name; });
  if (found == list.end()) return std::nullopt;
  return static_cast<std::size_t>(found - list.begin());
}

}  // namespace

std::string to_string(RobotJointType type) {
  switch (type) {
    case RobotJointType::revolute:
      return "revolute";
    case RobotJointType::continuous:
      return "continuous";
    case RobotJointType::prismatic:
      return "prismatic";
    case RobotJointType::fixed:
      break;
  }
  return "fixed";
}

bool is_moving(const RobotJoint& joint) { return joint.type != RobotJointType::fixed; }

std::vector<std::size_t> leaves(const Robot& robot) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    if (robot.links[k].children.empty()) found.push_back(k);
  }
  return found;
}

std::optional<std::size_t> link_named(const Robot& robot, const std::string& name) {
  return place_of(robot.links, name);
}

std::optional<std::size_t> joint_named(const Robot& robot, const std::string& name) {
  return place_of(robot.joints, name);
}

}  // namespace moivre
