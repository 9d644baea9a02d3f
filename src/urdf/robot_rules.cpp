// SPDX-License-Identifier: MIT
// Which rules does a robot break that was put together in code? What a reader makes breaks none.
#include <algorithm>
#include <set>

#include "moivre/urdf/robot.h"

namespace moivre {
namespace {

using Rules = std::vector<std::string>;

template <class List>
void check_names(const List& list, const std::string& what, Rules& broken) {
  std::set<std::string> taken;
  for (const auto& element : list) {
    if (element.name.empty()) broken.push_back("a " + what + " has no name");
    if (!element.name.empty() && !taken.insert(element.name).second) {
      broken.push_back("two " + what + "s are called '" + element.name + "'");
    }
  }
}

/// Every number of a vector can be worked with.
bool are_workable(const ExactVector& v) {
  return std::all_of(v.begin(), v.end(),
                     [](const Rational& x) { return is_workable(to_double(x)); });
}

bool is_zero_vector(const ExactVector& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& x) { return x.is_zero(); });
}

void check_joint(const Robot& robot, std::size_t index, Rules& broken) {
  const RobotJoint& joint = robot.joints[index];
  const std::string name = "joint '" + joint.name + "' ";
  const auto require = [&](bool is_right, const char* rule) {
    if (!is_right) broken.push_back(name + rule);
  };
  const std::size_t links = robot.links.size();
  require(joint.parent < links && joint.child < links, "ties a link that is not there");
  require(joint.parent != joint.child, "ties a link to itself");
  require(are_workable(joint.xyz) && are_workable(joint.rpy) && are_workable(joint.axis),
          "has a number beyond 1e50");
  require(!is_moving(joint) || !is_zero_vector(joint.axis), "needs an axis that is not zero");
  if (joint.limits) {
    const Limits& limits = *joint.limits;
    require(is_workable(limits.lower) && is_workable(limits.upper) && limits.lower <= limits.upper,
            "needs finite limits, the lower one first");
  }
  if (!joint.mimic) return;
  require(joint.mimic->leader < robot.joints.size(), "mimics a joint that is not there");
  require(is_workable(joint.mimic->multiplier) && is_workable(joint.mimic->offset),
          "mimics by a number that is not finite");
}

/// What links say of joints is what joints say of links.
void check_ties(const Robot& robot, Rules& broken) {
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    const RobotLink& link = robot.links[k];
    bool fits =
        !link.joint || (*link.joint < robot.joints.size() && robot.joints[*link.joint].child == k);
    for (const std::size_t child : link.children) {
      fits = fits && child < robot.joints.size() && robot.joints[child].parent == k;
    }
    const auto ties = std::count_if(robot.joints.begin(), robot.joints.end(),
                                    [&](const RobotJoint& joint) { return joint.parent == k; });
    fits = fits && static_cast<std::size_t>(ties) == link.children.size();
    if (!fits) broken.push_back("link '" + link.name + "' names other joints than name it");
  }
}

void check_tree(const Robot& robot, Rules& broken) {
  if (robot.links[robot.root].joint) broken.emplace_back("the root is the child of a joint");
  std::vector<bool> is_reached(robot.links.size());
  std::vector<std::size_t> open{robot.root};
  while (!open.empty()) {
    const std::size_t link = open.back();
    open.pop_back();
    if (is_reached[link]) {
      broken.push_back("link '" + robot.links[link].name + "' is the child of two joints");
      return;
    }
    is_reached[link] = true;
    for (const std::size_t joint : robot.links[link].children) {
      open.push_back(robot.joints[joint].child);
    }
  }
  for (std::size_t k = 0; k < is_reached.size(); ++k) {
    if (is_reached[k]) continue;
    broken.push_back("link '" + robot.links[k].name + "' is not tied to the root by joints");
  }
}

void check_mimics(const Robot& robot, Rules& broken) {
  for (const RobotJoint& joint : robot.joints) {
    const RobotJoint* at = &joint;
    std::size_t steps = 0;
    while (at->mimic && steps <= robot.joints.size()) {
      at = &robot.joints[at->mimic->leader];
      ++steps;
    }
    if (at->mimic) broken.push_back("joint '" + joint.name + "' mimics itself by way of others");
  }
}

}  // namespace

std::vector<std::string> broken_rules(const Robot& robot) {
  Rules broken;
  check_names(robot.links, "link", broken);
  check_names(robot.joints, "joint", broken);
  for (std::size_t k = 0; k < robot.joints.size(); ++k) check_joint(robot, k, broken);
  if (robot.root >= robot.links.size()) broken.emplace_back("the root is a link that is not there");
  if (broken.empty()) check_ties(robot, broken);
  if (!broken.empty()) return broken;
  check_tree(robot, broken);
  check_mimics(robot, broken);
  return broken;
}

}  // namespace moivre
