// SPDX-License-Identifier: MIT
// The mechanism file of a robot, line by line.
#include "moivre/urdf/mechanism_text.h"

#include <Eigen/Geometry>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>
#include <stdexcept>

#include "moivre/urdf/placement.h"

namespace moivre {
namespace {

/// What the text needs of every link and joint: names that a mechanism file takes, and frames at zero.
struct Layout {
  std::vector<std::string> bodies;  ///< of the links; "ground" the root
  std::vector<std::string> joints;  ///< also the points that a joint ties
  std::vector<Eigen::Matrix3d>
      rotation;  ///< of each link's frame in the root's, all joints at zero
};

/// Letters, digits, _ and -; a number behind it where the name is taken.
std::string typed_name(const std::string& name, std::set<std::string>& taken) {
  std::string clean;
  for (const char c : name) {
    const bool is_fit = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    clean += is_fit ? c : '_';
  }
  std::string unique = clean;
  for (int k = 2; !taken.insert(unique).second; ++k) unique = clean + "_" + std::to_string(k);
  return unique;
}

/// The angle as typed, or the right angle that it means where that is nearer than a nanoradian.
double meant_angle(const Rational& angle) {
  constexpr double kNanoradian = 1e-9;
  const auto quarters = quarter_turns(angle);
  const double typed = to_double(angle);
  const double right = quarters.value_or(0) * (std::numbers::pi / 2);
  return quarters && std::abs(typed - right) < kNanoradian ? right : typed;
}

/// Rotation with entries that are 0 and 1 where the angles are right.
Eigen::Matrix3d meant_rotation(const ExactVector& rpy) {
  Eigen::Matrix3d product = Eigen::Matrix3d::Identity();
  for (const int k : {2, 1, 0}) {
    const double angle = meant_angle(rpy[static_cast<std::size_t>(k)]);
    product *= Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(k)).toRotationMatrix();
  }
  constexpr double kRounding = 1e-15;
  return product.unaryExpr([](double x) { return std::abs(x) < kRounding ? 0 : x; });
}

/// Links in an order in which parents stand before their children.
std::vector<std::size_t> outwards(const Robot& robot) {
  std::vector<std::size_t> order{robot.root};
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const std::size_t joint : robot.links[order[k]].children) {
      order.push_back(robot.joints[joint].child);
    }
  }
  return order;
}

Layout layout_of(const Robot& robot) {
  Layout layout;
  std::set<std::string> bodies{"ground"};
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    layout.bodies.push_back(k == robot.root ? "ground" : typed_name(robot.links[k].name, bodies));
  }
  std::set<std::string> joints;
  for (const RobotJoint& joint : robot.joints) {
    layout.joints.push_back(typed_name(joint.name, joints));
  }
  layout.rotation.assign(robot.links.size(), Eigen::Matrix3d::Identity());
  for (const std::size_t link : outwards(robot)) {
    for (const std::size_t joint : robot.links[link].children) {
      layout.rotation[robot.joints[joint].child] =
          layout.rotation[link] * meant_rotation(robot.joints[joint].rpy);
    }
  }
  return layout;
}

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

std::string body_text(const Robot& robot, const Layout& layout, std::size_t link) {
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

/// Value of every joint that mimics, or is mimicked, where the leaders stand at zero or the limit that is nearest.
double driven_value(const Robot& robot, std::size_t number) {
  const RobotJoint& joint = robot.joints[number];
  if (joint.mimic) {
    return joint.mimic->multiplier * driven_value(robot, joint.mimic->leader) + joint.mimic->offset;
  }
  if (!joint.limits) return 0;
  return std::min(std::max(0.0, joint.limits->lower), joint.limits->upper);
}

std::string drivers_text(const Robot& robot, const Layout& layout) {
  std::set<std::size_t> driven;
  for (std::size_t k = 0; k < robot.joints.size(); ++k) {
    if (robot.joints[k].mimic) driven.insert({k, robot.joints[k].mimic->leader});
  }
  if (driven.empty()) return "";
  std::string text =
      "\n# Joints that mimic another are driven together with it: change their values together.\n";
  for (const std::size_t k : driven) {
    const RobotJoint& joint = robot.joints[k];
    const bool is_slide = joint.type == RobotJointType::prismatic;
    text += std::string("[[driver]]\n").append(is_slide ? "slide" : "angle") + " = " +
            quoted(layout.joints[k]) + "\nstart = " + number_text(driven_value(robot, k));
    if (joint.mimic) {
      text += "   # " + number_text(joint.mimic->multiplier) + " * " +
              layout.joints[joint.mimic->leader] + " + " + number_text(joint.mimic->offset);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::string mechanism_text(const Robot& robot, const std::string& file) {
  if (robot.joints.empty()) {
    throw std::invalid_argument(file + ": the robot has one link and no joint: no mechanism");
  }
  const Layout layout = layout_of(robot);
  std::string text = "# Robot " + in_comment(robot.name) + ", from " + in_comment(file) +
                     ".\n"
                     "# Frames: with all joints at zero every body's frame is parallel to the "
                     "ground's, its origin where its link's is.\n"
                     "# The ground is link " +
                     in_comment(robot.links[robot.root].name) + ".\ntitle = " + quoted(robot.name) +
                     "\nspace = \"spatial\"\n\n[units]\nlength = \"m\"\nangle  = \"rad\"\n";
  const std::vector<std::size_t> order = outwards(robot);
  for (const std::size_t link : order) text += body_text(robot, layout, link);
  for (const std::size_t link : order) {
    for (const std::size_t joint : robot.links[link].children) {
      text += joint_text(robot, layout, joint);
    }
  }
  return text + drivers_text(robot, layout);
}

}  // namespace moivre
