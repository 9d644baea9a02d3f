// SPDX-License-Identifier: MIT
// What is the robot? A tree of links and joints, as its URDF file has it, every number exactly as
// typed.
//
// A joint places its child's frame in its parent's. First comes the origin: xyz in metres, then the
// rotation rpy in radians, about the fixed axes x, y, z. Then comes the motion: a rotation about
// `axis`, or a displacement along it. The axis is in the child's frame.
// The root is the one link that is no joint's child; every other link is the child of exactly one.
// Not supported: planar and floating joints, loops (a URDF has none). What does not move anything
// (meshes, inertia, transmissions) is not kept.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "moivre/expression/source.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/numeric/rational.h"

namespace moivre {

enum class RobotJointType {
  revolute,    ///< turns, has limits
  continuous,  ///< turns without end
  prismatic,   ///< slides, has limits
  fixed
};

std::string to_string(RobotJointType type);

using ExactVector = std::array<Rational, 3>;

/// This joint stands at multiplier * (value of `leader`) + offset.
struct Mimic {
  std::size_t leader = 0;  ///< joint
  double multiplier = 1;
  double offset = 0;
};

struct RobotJoint {
  std::string name;
  RobotJointType type = RobotJointType::fixed;
  std::size_t parent = 0;  ///< link
  std::size_t child = 0;   ///< link
  ExactVector xyz;
  ExactVector rpy;
  ExactVector axis{1, 0, 0};     ///< not zero, of any length
  std::optional<Limits> limits;  ///< revolute, prismatic
  std::optional<Mimic> mimic;
  SourcePosition where;
};

struct RobotLink {
  std::string name;
  std::optional<std::size_t> joint;   ///< of which it is the child; none: the root
  std::vector<std::size_t> children;  ///< joints of which it is the parent
  SourcePosition where;
};

struct Robot {
  std::string name;
  std::vector<RobotLink> links;
  std::vector<RobotJoint> joints;
  std::size_t root = 0;
};

/// A joint that stands at a value (urdf/choice.h).
struct HeldJoint {
  std::string name;
  double value = 0;               ///< radians, or metres
  bool is_beyond_limits = false;  ///< of an arm's: it is held there all the same
};

/// Every broken rule as a sentence, empty where there is none: joints make one tree of the links,
/// names are given and differ, numbers can be worked with, axes of moving joints are not zero, no
/// joint mimics itself. What a reader makes breaks none.
std::vector<std::string> broken_rules(const Robot& robot);

bool is_moving(const RobotJoint& joint);
/// Links that are no joint's parent, in the order of the file.
std::vector<std::size_t> leaves(const Robot& robot);
std::optional<std::size_t> link_named(const Robot& robot, const std::string& name);
std::optional<std::size_t> joint_named(const Robot& robot, const std::string& name);

}  // namespace moivre
