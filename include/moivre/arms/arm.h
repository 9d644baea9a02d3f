// SPDX-License-Identifier: MIT
// Which serial chain do a robot's joints form between two links? Its free joints in order, and the
// fixed displacements between them.
//
//   pose of the tip in the base = B_1 J_1(x_1) B_2 J_2(x_2) ... B_n J_n(x_n) T
//   J_i: a turn by x_i (radians) about the unit axis a_i, or a displacement by x_i along it (the
//   file's unit, metres);
//   B_i, T: fixed displacements: origins, fixed joints, held joints.
// Each B_i is stored twice: as a transform of the numbers as typed, and as an exact dual quaternion
// of integers, in which angles that are meant to be right are exactly right (urdf/placement.h). The
// polynomials use the exact ones, the last digits the others.
// Edges: the base need not be above the tip in the tree. Joints on the way up are passed backwards
// and turn the other way.
// A joint that mimics one outside the chain is free. A joint that mimics a held one is held with
// it.
// Not supported: a joint that mimics a free one in the chain; chains without a free joint, or with
// more than six.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "moivre/urdf/robot.h"

namespace moivre {

/// A displacement of integers (exact_motion.h); make_arm() makes it.
struct ExactMotion;
using ExactPointer = std::shared_ptr<const ExactMotion>;

struct ArmJoint {
  std::string name;
  bool is_slide = false;
  std::optional<Limits> limits;                              ///< none: it turns without end
  Eigen::Isometry3d before = Eigen::Isometry3d::Identity();  ///< B_i
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();           ///< a_i, unit
  ExactPointer exact_before;                                 ///< B_i
  /// J_i = c + s step, up to a factor: s/c = tan(x_i/2) / exact_length of a turn, 1 / exact_length
  /// of a slide.
  ExactPointer step;
  double exact_length = 1;  ///< of the axis as typed
};

struct Arm {
  std::string robot, base, tip;
  std::vector<ArmJoint> joints;
  Eigen::Isometry3d tool = Eigen::Isometry3d::Identity();  ///< T
  ExactPointer exact_tool;                                 ///< T
  std::vector<HeldJoint> held;
  double length = 1;  ///< of the arm stretched out; 1 where it has none
  /// By how much the tip may stand elsewhere since the file's numbers are rounded: radians, and
  /// lengths relative to the arm's.
  double rounding = 0;
};

struct ArmChoice {
  std::optional<std::string> base;  ///< default: the root
  std::optional<std::string> tip;   ///< default: the leaf, where there is one alone
  std::vector<HeldJoint> held;      ///< radians, or metres
};

/// Throws std::invalid_argument with every fault, and the links or joints to choose from.
Arm make_arm(const Robot& robot, const ArmChoice& choice);

/// Whether a joint slides.
bool has_slides(const Arm& arm);

/// Each joint's frame after its motion, in the base's frame: B_1 J_1 ... B_k J_k. Its origin is on
/// the joint's axis.
std::vector<Eigen::Isometry3d> joint_frames(const Arm& arm, const Eigen::VectorXd& values);

/// Where the tip is.
Eigen::Isometry3d forward_kinematics(const Arm& arm, const Eigen::VectorXd& values);

/// Every broken rule as a sentence; empty where none is. Of an arm that make_arm() made none is.
std::vector<std::string> broken_rules(const Arm& arm);

}  // namespace moivre
