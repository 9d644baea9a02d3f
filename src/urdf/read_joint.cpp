// SPDX-License-Identifier: MIT
// How is a <joint> read? Type, the two links, origin, axis, limits, and what it mimics.
#include <algorithm>
#include <cmath>

#include "moivre/mechanism/nearest.h"
#include "read_parts.h"

namespace moivre {
namespace {

std::vector<std::string> names_of(const Numbers& numbers) {
  std::vector<std::string> names;
  for (const auto& [name, number] : numbers) names.push_back(name);
  return names;
}

std::optional<RobotJointType> read_type(XmlReading& reading, const pugi::xml_node& node,
                                        const std::string& what) {
  const auto word = reading.text(node, "type", what);
  if (!word) return std::nullopt;
  std::vector<std::string> known;
  for (const RobotJointType type : {RobotJointType::revolute, RobotJointType::continuous,
                                    RobotJointType::prismatic, RobotJointType::fixed}) {
    if (to_string(type) == *word) return type;
    known.push_back(to_string(type));
  }
  std::string reason = "unknown joint type '" + *word + "'" + suggestion(*word, known);
  if (*word == "floating" || *word == "planar") {
    reason = "a " + *word + " joint leaves " + (*word == "planar" ? "three" : "six") +
             " freedoms between two links and is not supported; write one revolute, continuous or "
             "prismatic joint for each, or fix it";
  }
  reading.fault(node.attribute("type"), reason);
  return std::nullopt;
}

/// The number of the link that <parent> or <child> names.
std::optional<std::size_t> read_end(XmlReading& reading, const pugi::xml_node& node,
                                    const char* end, const std::string& what,
                                    const Numbers& links) {
  const pugi::xml_node found = reading.only_child(node, end);
  if (!found) {
    reading.fault(node, what + std::string(" needs <").append(end) + " link=\"...\"/>");
    return std::nullopt;
  }
  const auto name = reading.text(found, "link", std::string("<").append(end) + ">");
  if (!name) return std::nullopt;
  const auto link = links.find(*name);
  if (link != links.end()) return link->second;
  reading.fault(found.attribute("link"),
                "there is no link '" + *name + "'" + suggestion(*name, names_of(links)));
  return std::nullopt;
}

void read_origin(XmlReading& reading, const pugi::xml_node& node, RobotJoint& joint) {
  const pugi::xml_node origin = reading.only_child(node, "origin");
  if (!origin) return;
  reading.check_spelling(origin, {}, {"xyz", "rpy"});
  if (const pugi::xml_attribute quaternion = origin.attribute("quat_xyzw")) {
    reading.fault(quaternion, "'quat_xyzw' is not supported; write the turn as rpy");
  }
  joint.xyz = reading.vector(origin, "xyz").value_or(ExactVector{});
  joint.rpy = reading.vector(origin, "rpy").value_or(ExactVector{});
  for (const Rational& angle : joint.rpy) {
    if (is_workable_angle(to_double(angle))) continue;
    reading.fault(origin.attribute("rpy"), "'rpy' has an angle of more than a million turns");
    break;
  }
}

void read_axis(XmlReading& reading, const pugi::xml_node& node, RobotJoint& joint) {
  const pugi::xml_node axis = reading.only_child(node, "axis");
  if (!axis) return;
  reading.check_spelling(axis, {}, {"xyz"});
  if (!axis.attribute("xyz")) {
    reading.fault(axis, "<axis> needs the attribute 'xyz'");
    return;
  }
  const auto direction = reading.vector(axis, "xyz");
  if (!direction) return;
  const bool is_zero = std::all_of(direction->begin(), direction->end(),
                                   [](const Rational& x) { return x.is_zero(); });
  if (!is_zero) {
    joint.axis = *direction;
  } else if (is_moving(joint)) {
    reading.fault(axis.attribute("xyz"), "the axis of a moving joint must not be the zero vector");
  }
}

void read_limits(XmlReading& reading, const pugi::xml_node& node, const std::string& what,
                 RobotJoint& joint) {
  const pugi::xml_node limit = reading.only_child(node, "limit");
  const bool has_bounds =
      joint.type == RobotJointType::revolute || joint.type == RobotJointType::prismatic;
  if (!limit) {
    if (has_bounds) {
      reading.fault(node, what + " is " + to_string(joint.type) +
                              " and needs <limit lower=\"...\" upper=\"...\"/>" +
                              (joint.type == RobotJointType::revolute
                                   ? "; one that turns without end is continuous"
                                   : ""));
    }
    return;
  }
  reading.check_spelling(limit, {}, {"lower", "upper", "effort", "velocity"});
  const auto lower = reading.number(limit, "lower");
  const auto upper = reading.number(limit, "upper");
  if (!has_bounds) return;
  joint.limits = Limits{lower.value_or(0), upper.value_or(0)};
  if (joint.limits->lower > joint.limits->upper) {
    reading.fault(limit, "the lower limit is above the upper one");
  }
}

}  // namespace

RobotJoint read_joint(XmlReading& reading, const pugi::xml_node& node, const std::string& name,
                      const Numbers& links) {
  RobotJoint joint;
  joint.name = name;
  joint.where = reading.position(node);
  const std::string what = name.empty() ? "the joint" : "joint '" + name + "'";
  reading.check_spelling(node,
                         {"origin", "parent", "child", "axis", "limit", "mimic", "dynamics",
                          "calibration", "safety_controller"},
                         {"name", "type"});
  const auto type = read_type(reading, node, what);
  joint.type = type.value_or(RobotJointType::fixed);
  const auto parent = read_end(reading, node, "parent", what, links);
  const auto child = read_end(reading, node, "child", what, links);
  joint.parent = parent.value_or(0);
  joint.child = child.value_or(0);
  if (parent && child && *parent == *child) {
    reading.fault(node, what + " has link '" + node.child("child").attribute("link").value() +
                            "' as parent and as child");
  }
  read_origin(reading, node, joint);
  read_axis(reading, node, joint);
  read_limits(reading, node, what, joint);
  return joint;
}

void read_mimic(XmlReading& reading, const pugi::xml_node& node, std::size_t number,
                const Numbers& joints, Robot& robot) {
  const pugi::xml_node mimic = reading.only_child(node, "mimic");
  if (!mimic) return;
  reading.check_spelling(mimic, {}, {"joint", "multiplier", "offset"});
  const double multiplier = reading.number(mimic, "multiplier").value_or(1);
  const double offset = reading.number(mimic, "offset").value_or(0);
  const auto name = reading.text(mimic, "joint", "<mimic>");
  if (!name) return;
  const auto leader = joints.find(*name);
  RobotJoint& joint = robot.joints[number];
  if (leader == joints.end()) {
    reading.fault(mimic.attribute("joint"),
                  "there is no joint '" + *name + "'" + suggestion(*name, names_of(joints)));
  } else if (leader->second == number) {
    reading.fault(mimic.attribute("joint"), "joint '" + *name + "' mimics itself");
  } else if (!is_moving(joint)) {
    reading.fault(mimic, "a fixed joint mimics nothing; remove <mimic>, or give it another type");
  } else if (!is_moving(robot.joints[leader->second])) {
    reading.fault(mimic.attribute("joint"), "joint '" + *name + "' is fixed: nothing to mimic");
  } else {
    joint.mimic = Mimic{leader->second, multiplier, offset};
  }
}

}  // namespace moivre
