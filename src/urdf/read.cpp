// SPDX-License-Identifier: MIT
// How is a URDF file read? XML first, then links, then joints, then the tree, every fault noted,
// thrown together.
#include "moivre/urdf/read.h"

#include <algorithm>

#include "moivre/expression/words.h"
#include "moivre/mechanism/nearest.h"
#include "read_parts.h"

namespace moivre {
namespace {

constexpr std::size_t kMostElements = 20'000;

/// What a file with another root is; empty where nobody knows.
std::string advice_on(const std::string& root) {
  if (root == "sdf") return "; this is SDF, convert it to URDF";
  if (root == "mujoco") return "; this is MuJoCo's format, convert it to URDF";
  if (root == "html" || root == "HTML") return "; this is a web page, was the raw file meant?";
  return suggestion(root, {"robot"});
}

void check_root(XmlReading& reading, Robot& robot) {
  const pugi::xml_node root = reading.root();
  const std::string name = root.name();
  if (name != "robot") {
    reading.fault(root,
                  "the root element of a URDF is <robot>, not <" + name + ">" + advice_on(name));
    return;
  }
  robot.name = reading.text(root, "name", "<robot>").value_or("");
  for (const pugi::xml_node& child : root.children()) {
    if (!std::string_view(child.name()).starts_with("xacro:")) continue;
    reading.fault(child, std::string("<").append(child.name()) +
                             "> is for xacro; run xacro first and give its result");
    return;
  }
  reading.check_spelling(root, {"link", "joint", "material", "transmission", "gazebo", "sensor"},
                         {});
}

/// The name, or "" and a fault; one that is there already is a fault, too.
std::string read_name(XmlReading& reading, const pugi::xml_node& node, const std::string& kind,
                      const Numbers& taken) {
  const std::string name = reading.text(node, "name", "a " + kind).value_or("");
  if (taken.contains(name)) {
    reading.fault(node.attribute("name"), "a second " + kind + " is called '" + name + "'");
  }
  return name;
}

std::vector<pugi::xml_node> children_of(const pugi::xml_node& root, const char* name) {
  std::vector<pugi::xml_node> found;
  for (const pugi::xml_node& node : root.children(name)) found.push_back(node);
  return found;
}

void read_elements(XmlReading& reading, Robot& robot) {
  const std::vector<pugi::xml_node> links = children_of(reading.root(), "link");
  const std::vector<pugi::xml_node> joints = children_of(reading.root(), "joint");
  if (links.empty()) reading.fault(reading.root(), "the robot has no <link>");
  if (links.size() + joints.size() > kMostElements) {
    reading.fault(reading.root(), "there are more than 20,000 links and joints");
    return;
  }
  Numbers link_numbers;
  for (const pugi::xml_node& node : links) {
    const std::string name = read_name(reading, node, "link", link_numbers);
    link_numbers.emplace(name, robot.links.size());
    robot.links.push_back({name, {}, {}, reading.position(node)});
  }
  Numbers joint_numbers;
  for (const pugi::xml_node& node : joints) {
    const std::string name = read_name(reading, node, "joint", joint_numbers);
    joint_numbers.emplace(name, robot.joints.size());
    robot.joints.push_back(read_joint(reading, node, name, link_numbers));
  }
  for (std::size_t k = 0; k < joints.size(); ++k) {
    read_mimic(reading, joints[k], k, joint_numbers, robot);
  }
  if (!links.empty()) check_tree(reading, links, joints, robot);
}

}  // namespace

bool looks_like_xml(const std::string& text) {
  const std::string_view content = trimmed(text);
  return content.starts_with('<');
}

Robot read_urdf(const Source& source) {
  XmlReading reading(source);
  Robot robot;
  check_root(reading, robot);
  const bool is_robot = std::string_view(reading.root().name()) == "robot";
  if (is_robot) read_elements(reading, robot);
  std::vector<Diagnostic>& faults = reading.faults();
  if (!faults.empty()) {
    std::stable_sort(faults.begin(), faults.end(), [](const Diagnostic& a, const Diagnostic& b) {
      return a.at.offset < b.at.offset;
    });
    throw ParseError(source, faults);
  }
  return robot;
}

}  // namespace moivre
