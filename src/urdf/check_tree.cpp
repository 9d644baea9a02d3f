// SPDX-License-Identifier: MIT
// Do the joints make one tree of the links? What no single joint shows: two parents, loops, several
// roots, circles of mimics.
#include <algorithm>

#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "read_parts.h"

namespace moivre {
namespace {

/// Roots that a message names.
constexpr std::size_t kListed = 8;

void tie_links(XmlReading& reading, const std::vector<pugi::xml_node>& joints, Robot& robot) {
  for (std::size_t k = 0; k < robot.joints.size(); ++k) {
    const RobotJoint& joint = robot.joints[k];
    robot.links[joint.parent].children.push_back(k);
    RobotLink& child = robot.links[joint.child];
    if (child.joint) {
      reading.fault(joints[k].child("child").attribute("link"),
                    "link '" + child.name + "' is the child of joint '" +
                        robot.joints[*child.joint].name +
                        "' already; a URDF is a tree, loops go into a side file (--loops)");
    } else {
      child.joint = k;
    }
  }
}

/// Each link belongs to the tree of one root; links of none are in a loop.
std::vector<bool> reached_from(const Robot& robot, const std::vector<std::size_t>& roots) {
  std::vector<bool> is_reached(robot.links.size());
  std::vector<std::size_t> open = roots;
  while (!open.empty()) {
    const std::size_t link = open.back();
    open.pop_back();
    if (is_reached[link]) continue;
    is_reached[link] = true;
    for (const std::size_t joint : robot.links[link].children) {
      open.push_back(robot.joints[joint].child);
    }
  }
  return is_reached;
}

void find_root(XmlReading& reading, const std::vector<pugi::xml_node>& links, Robot& robot) {
  std::vector<std::size_t> roots;
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    if (!robot.links[k].joint) roots.push_back(k);
  }
  const std::vector<bool> is_reached = reached_from(robot, roots);
  const auto lost = std::find(is_reached.begin(), is_reached.end(), false);
  if (lost != is_reached.end()) {
    const auto k = static_cast<std::size_t>(lost - is_reached.begin());
    reading.fault(links[k], "link '" + robot.links[k].name +
                                "' hangs on itself: its joints go round in a loop and reach no "
                                "root");
  }
  if (roots.size() > 1) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < std::min(roots.size(), kListed); ++k) {
      names.push_back("'" + robot.links[roots[k]].name + "'");
    }
    if (roots.size() > kListed) names.emplace_back("...");
    reading.fault(links[roots[1]],
                  "there are " + counted(roots.size(), "root") +
                      ", links that no joint has as child: " + joined(names, ", ") +
                      "; tie them by joints, fixed ones say");
  }
  if (!roots.empty()) robot.root = roots.front();
}

void check_mimics(XmlReading& reading, const std::vector<pugi::xml_node>& joints, Robot& robot) {
  for (std::size_t k = 0; k < robot.joints.size(); ++k) {
    std::size_t steps = 0;
    std::size_t at = k;
    while (robot.joints[at].mimic && steps <= robot.joints.size()) {
      at = robot.joints[at].mimic->leader;
      ++steps;
      if (at == k) break;
    }
    if (steps == 0 || at != k) continue;
    reading.fault(joints[k].child("mimic"),
                  "joint '" + robot.joints[k].name + "' mimics itself by way of others");
  }
}

}  // namespace

void check_tree(XmlReading& reading, const std::vector<pugi::xml_node>& links,
                const std::vector<pugi::xml_node>& joints, Robot& robot) {
  tie_links(reading, joints, robot);
  if (reading.faults().empty()) find_root(reading, links, robot);
  check_mimics(reading, joints, robot);
}

}  // namespace moivre
