// SPDX-License-Identifier: MIT
// What must hold for any bytes that the URDF reader is given, or that are a robot's side file? A
// robot that is a tree and a mechanism, or faults in the text.
//
// Shared by the fuzz target and by the test that changes bytes at random.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "moivre/mechanism/read.h"
#include "moivre/urdf/mechanism_text.h"
#include "moivre/urdf/read.h"

namespace moivre {

/// The law that faults break, if any: each has words, and a place in the text.
inline std::optional<std::string> broken_fault_law(const ParseError& error,
                                                   const std::string& bytes) {
  if (error.diagnostics().empty()) return "a ParseError without a fault";
  for (const Diagnostic& fault : error.diagnostics()) {
    if (fault.at.offset > bytes.size() || fault.message.empty()) {
      return "a fault outside the text";
    }
    if (after({}, std::string_view(bytes).substr(0, fault.at.offset)) != fault.at) {
      return "a fault whose line and column are not those of its offset: " + fault.message;
    }
  }
  return std::nullopt;
}

/// The law that a robot breaks, if any.
inline std::optional<std::string> broken_robot_law(const Robot& robot) {
  if (robot.links.size() != robot.joints.size() + 1) return "a tree of another number of joints";
  for (const RobotJoint& joint : robot.joints) {
    if (joint.parent >= robot.links.size() || joint.child >= robot.links.size()) {
      return "a joint of a link that is not there";
    }
  }
  if (robot.joints.empty()) return std::nullopt;
  try {
    read_mechanism({"mechanism", mechanism_text(robot, "fuzz")});
  } catch (const ParseError& error) {
    const std::string what = error.what();
    const bool is_bound = what.find("largest length") != std::string::npos ||
                          what.find("beyond 1e50") != std::string::npos ||
                          what.find("bodies") != std::string::npos;
    if (!is_bound) return "a mechanism that is refused: " + what;
  }
  return std::nullopt;
}

/// The law that the bytes break, if any.
inline std::optional<std::string> broken_urdf_law(const std::string& bytes) {
  try {
    return broken_robot_law(read_urdf({"fuzz", bytes}));
  } catch (const ParseError& error) {
    return broken_fault_law(error, bytes);
  }
}

/// The law that the bytes break as a side file of the robot, if any.
inline std::optional<std::string> broken_side_file_law(const Robot& robot,
                                                       const std::string& bytes) {
  RobotChanges changes;
  changes.loops = Source{"fuzz", bytes};
  std::string text;
  try {
    text = mechanism_text(robot, "robot", changes);
  } catch (const ParseError& error) {
    return broken_fault_law(error, bytes);
  }
  try {
    read_mechanism({"mechanism", text});
  } catch (const ParseError& error) {
    return std::string("a side file is taken whose mechanism is refused: ") + error.what();
  }
  return std::nullopt;
}

}  // namespace moivre
