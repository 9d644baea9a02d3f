// SPDX-License-Identifier: MIT
// The mechanism file of a robot, line by line.
#include "moivre/urdf/mechanism_text.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <set>

#include "layout.h"
#include "moivre/expression/joined.h"
#include "moivre/mechanism/additions.h"
#include "moivre/mechanism/read.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/urdf/placement.h"

namespace moivre {
namespace {

/// At most twelve decimals, no more than it takes.
std::string number_text(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.12f", x);
  std::string short_text = text;
  short_text.erase(short_text.find_last_not_of('0') + 1);
  if (short_text.back() == '.') short_text.pop_back();
  return short_text == "-0" ? "0" : short_text;
}

std::string vector_text(const Eigen::Vector3d& v) {
  return "[" + number_text(v.x()) + ", " + number_text(v.y()) + ", " + number_text(v.z()) + "]";
}

/// A TOML string.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') result += '\\';
    result += byte < 0x20U || byte == 0x7FU ? '?' : c;
  }
  return result + '"';
}

/// A comment holds no line break.
std::string in_comment(const std::string& text) {
  const std::string as_string = quoted(text);
  return as_string.substr(1, as_string.size() - 2);
}

/// `more` are points beside those of the joints.
std::string body_text(const Robot& robot, const Layout& layout, std::size_t link,
                      const std::vector<BodyPoint>& more) {
  const RobotLink& body = robot.links[link];
  std::string text = std::string("\n[").append(link == robot.root ? "" : "body.") +
                     layout.bodies[link] + ".points]";
  if (layout.bodies[link] != body.name) text += "   # link " + in_comment(body.name);
  text += '\n';
  if (body.joint) text += layout.joints[*body.joint] + " = [0, 0, 0]\n";
  for (const std::size_t k : body.children) {
    const Eigen::Vector3d at = layout.rotation[link] * to_vector(robot.joints[k].xyz);
    text += layout.joints[k] + " = " + vector_text(at) + '\n';
  }
  for (const BodyPoint& point : more) text += point.name + " = " + vector_text(point.at) + '\n';
  return text;
}

std::string type_text(RobotJointType type) {
  switch (type) {
    case RobotJointType::prismatic:
      return "prismatic";
    case RobotJointType::fixed:
      return "weld";
    case RobotJointType::revolute:
    case RobotJointType::continuous:
      break;
  }
  return "revolute";
}

std::string joint_text(const Robot& robot, const Layout& layout, std::size_t number) {
  const RobotJoint& joint = robot.joints[number];
  const std::string& name = layout.joints[number];
  std::string text =
      "\n[[joint]]\nname = " + quoted(name) + "\ntype = \"" + type_text(joint.type) + "\"";
  if (joint.type == RobotJointType::continuous) text += "   # continuous";
  text += "\nat   = [\"" + layout.bodies[joint.parent] + "." + name + "\", \"" +
          layout.bodies[joint.child] + "." + name + "\"]\n";
  if (!is_moving(joint)) return text;
  const Eigen::Vector3d axis =
      layout.rotation[joint.child] * to_vector(joint.axis).stableNormalized();
  text += "axis = " + vector_text(axis) + '\n';
  if (joint.limits) {
    text += "limits = [" + number_text(joint.limits->lower) + ", " +
            number_text(joint.limits->upper) + "]\n";
  }
  return text;
}

/// Value of a joint that mimics, is mimicked or held, where leaders stand at zero or the limit that
/// is nearest.
double driven_value(const Robot& robot, std::size_t number, const std::vector<HeldJoint>& held) {
  if (const auto value = held_value(robot, number, held)) return *value;
  const RobotJoint& joint = robot.joints[number];
  if (joint.mimic) {
    return joint.mimic->multiplier * driven_value(robot, joint.mimic->leader, held) +
           joint.mimic->offset;
  }
  if (!joint.limits) return 0;
  return std::min(std::max(0.0, joint.limits->lower), joint.limits->upper);
}

/// Joints that need a driver of their own: those that are held, mimic or are mimicked, and that no
/// side file drives.
std::set<std::size_t> joints_to_drive(const Robot& robot, const RobotChanges& changes,
                                      const std::vector<std::optional<std::size_t>>& driven) {
  std::set<std::size_t> joints;
  for (std::size_t k = 0; k < robot.joints.size(); ++k) {
    if (robot.joints[k].mimic) joints.insert({k, robot.joints[k].mimic->leader});
  }
  for (const HeldJoint& one : changes.held) joints.insert(*joint_named(robot, one.name));
  for (const auto& joint : driven) {
    if (joint) joints.erase(*joint);
  }
  return joints;
}

std::string drivers_text(const Robot& robot, const Layout& layout, const RobotChanges& changes,
                         const std::set<std::size_t>& joints) {
  if (joints.empty()) return "";
  std::string text =
      "\n# Joints that are held, and joints that mimic another: these are driven together with it, "
      "change their values together.\n";
  for (const std::size_t k : joints) {
    const RobotJoint& joint = robot.joints[k];
    const bool is_slide = joint.type == RobotJointType::prismatic;
    text += std::string("[[driver]]\n").append(is_slide ? "slide" : "angle") + " = " +
            quoted(layout.joints[k]) +
            "\nstart = " + number_text(driven_value(robot, k, changes.held));
    if (joint.mimic) {
      text += "   # " + number_text(joint.mimic->multiplier) + " * " +
              layout.joints[joint.mimic->leader] + " + " + number_text(joint.mimic->offset);
    }
    text += '\n';
  }
  return text;
}

/// Of the file without its drivers.
std::string skeleton_text(const Robot& robot, const Layout& layout, const std::string& file,
                          const Additions& additions) {
  const std::string& title = additions.title.empty() ? robot.name : additions.title;
  std::string text = "# Robot " + in_comment(robot.name) + ", from " + in_comment(file) +
                     ".\n"
                     "# Frames: with all joints at zero every body's frame is parallel to the "
                     "ground's, its origin where its link's is.\n"
                     "# The ground is link " +
                     in_comment(robot.links[robot.root].name) + ".\ntitle = " + quoted(title) +
                     "\nspace = \"spatial\"\n\n[units]\nlength = \"m\"\nangle  = \"rad\"\n";
  std::size_t body = 0;
  for (const std::size_t link : layout.order) {
    text += body_text(robot, layout, link, additions.points[body++]);
  }
  for (const std::size_t link : layout.order) {
    for (const std::size_t joint : robot.links[link].children) {
      text += joint_text(robot, layout, joint);
    }
  }
  return text + additions.joints;
}

Additions nothing_added(const Robot& robot) {
  Additions nothing;
  nothing.points.resize(robot.links.size());
  return nothing;
}

/// The side file, read against the robot as it stands alone.
Additions read_loops(const Robot& robot, const Layout& layout, const Source& loops) {
  const std::string alone = skeleton_text(robot, layout, "", nothing_added(robot));
  const Mechanism mechanism = read_mechanism({robot.name, alone});
  std::vector<Eigen::Matrix3d> frames;
  for (const std::size_t link : layout.order) frames.push_back(layout.rotation[link]);
  return read_additions(loops, mechanism, frames);
}

/// The joint of the robot that each driver of the side file moves; none where it moves another or a
/// point. In the mechanism the joints stand in the order of the links.
std::vector<std::optional<std::size_t>> driven_joints(const Robot& robot, const Layout& layout,
                                                      const Additions& additions) {
  std::vector<std::size_t> order;
  for (const std::size_t link : layout.order) {
    const auto& children = robot.links[link].children;
    order.insert(order.end(), children.begin(), children.end());
  }
  std::vector<std::optional<std::size_t>> driven;
  for (const Driver& driver : additions.driven) {
    const bool is_of_joint = driver.kind == DriverKind::angle || driver.kind == DriverKind::slide;
    const bool is_robots = is_of_joint && driver.joint < order.size();
    driven.push_back(is_robots ? std::optional(order[driver.joint]) : std::nullopt);
  }
  return driven;
}

/// What a driver of the side file contradicts: a joint that is held, and joints that mimic the
/// driven one and are not driven.
void check_driven(const Robot& robot, const RobotChanges& changes, const Additions& additions,
                  const std::vector<std::optional<std::size_t>>& driven) {
  std::vector<Diagnostic> faults;
  for (std::size_t k = 0; k < driven.size(); ++k) {
    if (!driven[k]) continue;
    const SourcePosition at = additions.driven[k].where;
    if (held_value(robot, *driven[k], changes.held)) {
      faults.push_back({at, "joint '" + robot.joints[*driven[k]].name +
                                "' is held; remove this driver, or do not hold the joint"});
    }
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      const RobotJoint& joint = robot.joints[j];
      const bool follows = joint.mimic && joint.mimic->leader == *driven[k];
      if (!follows || std::find(driven.begin(), driven.end(), j) != driven.end()) continue;
      faults.push_back({at, "joint '" + joint.name + "' mimics this one: drive it too, at " +
                                number_text(joint.mimic->multiplier) + " times this value plus " +
                                number_text(joint.mimic->offset)});
    }
  }
  if (!faults.empty()) throw ParseError(*changes.loops, std::move(faults));
}

/// Adds the point of the ground where the tip is to be; the weld that holds it there.
std::string weld_tip(const Robot& robot, const Layout& layout, std::size_t tip,
                     const Eigen::Isometry3d& pose, Additions& additions) {
  std::set<std::string> taken(layout.joints.begin(), layout.joints.end());
  for (const BodyPoint& point : additions.points[0]) taken.insert(point.name);
  const std::string name = typed_name("pose", taken);
  additions.points[0].push_back({name, pose.translation(), {}});
  const Eigen::AngleAxisd turn(pose.linear() * layout.rotation[tip].transpose());
  return "\n[[joint]]\ntype = \"weld\"\nat = [\"ground." + name + "\", \"" + layout.bodies[tip] +
         "." + layout.joints[*robot.links[tip].joint] + "\"]\naxis = " + vector_text(turn.axis()) +
         "\nturn = " + number_text(turn.angle()) + '\n';
}

void check_changes(const Robot& robot, const RobotChanges& changes, const std::string& file,
                   std::size_t tip, std::vector<std::string> faults) {
  if (robot.joints.empty()) {
    faults.push_back(file + ": the robot has one link and no joint: no mechanism");
  }
  check_held(robot, changes.held, faults);
  if (changes.pose && tip == robot.root) {
    faults.emplace_back("the tip is the root, which stands; choose another by `tip`");
  }
  require_unbroken(faults);
}

}  // namespace

std::string mechanism_text(const Robot& robot, const std::string& file,
                           const RobotChanges& changes) {
  require_unbroken(broken_rules(robot));
  std::vector<std::string> faults;
  const bool has_tip = changes.pose || changes.tip;
  const std::size_t tip = has_tip ? find_tip(robot, changes.tip, faults) : robot.root;
  check_changes(robot, changes, file, tip, faults);
  const Layout layout = layout_of(robot);
  Additions additions =
      changes.loops ? read_loops(robot, layout, *changes.loops) : nothing_added(robot);
  const auto driven = driven_joints(robot, layout, additions);
  check_driven(robot, changes, additions, driven);
  if (changes.pose) additions.joints += weld_tip(robot, layout, tip, *changes.pose, additions);
  return skeleton_text(robot, layout, file, additions) + additions.drivers +
         drivers_text(robot, layout, changes, joints_to_drive(robot, changes, driven)) +
         additions.guess;
}

}  // namespace moivre
