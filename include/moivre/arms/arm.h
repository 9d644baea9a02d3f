// SPDX-License-Identifier: MIT
// Which serial chain do a robot's joints make between two links? Its free joints in order, and what stands still between them.
//
//   pose of the tip in the base = B_1 J_1(x_1) B_2 J_2(x_2) ... B_n J_n(x_n) T
//   J_i: a turn by x_i (radians) about the unit axis a_i, or a displacement by x_i along it (the file's unit, metres);
//   B_i, T: displacements that do not change: origins, fixed joints, held ones.
// Each B_i is there twice: as a transform of the numbers as typed, and exactly, as a dual quaternion of integers in which right
// angles that are meant are right (urdf/placement.h). The exact ones make the polynomials, the others the last digits.
// Edges: the base need not be above the tip in the tree; joints on the way up are passed backwards, and turn the other way.
// A joint that mimics one outside the chain is free; one that mimics a held joint is held with it.
// Not supported: a joint that mimics a free one in the chain; chains without a free joint, or with more than six.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "moivre/arms/dual_quaternion.h"
#include "moivre/numeric/integer.h"
#include "moivre/urdf/robot.h"

namespace moivre {

using ExactDisplacement = DualQuaternion<Integer>;

struct ArmJoint {
  std::string name;
  bool is_slide = false;
  std::optional<Limits> limits;                              ///< none: it turns without end
  Eigen::Isometry3d before = Eigen::Isometry3d::Identity();  ///< B_i
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();           ///< a_i, unit
  ExactDisplacement exact_before{1};                         ///< B_i
  /// J_i = c + s step, up to a factor: s/c = tan(x_i/2) / exact_length of a turn, 1 / exact_length of a slide.
  ExactDisplacement step{};
  double exact_length = 1;  ///< of the axis as typed
};

struct HeldJoint {
  std::string name;
  double value = 0;
};

struct Arm {
  std::string robot, base, tip;
  std::vector<ArmJoint> joints;
  Eigen::Isometry3d tool = Eigen::Isometry3d::Identity();  ///< T
  ExactDisplacement exact_tool{1};
  std::vector<HeldJoint> held;
  double length = 1;  ///< of the arm stretched out; 1 where it has none
};

struct ArmChoice {
  std::optional<std::string> base;  ///< default: the root
  std::optional<std::string> tip;   ///< default: the leaf, where there is one alone
  std::vector<HeldJoint> held;      ///< radians, or metres
};

/// Throws std::invalid_argument that names every fault, with the links or joints to choose from.
Arm make_arm(const Robot& robot, const ArmChoice& choice);

/// Each joint's frame behind its motion, in the base's: B_1 J_1 ... B_k J_k. Its origin is on the joint's axis.
std::vector<Eigen::Isometry3d> joint_frames(const Arm& arm, const Eigen::VectorXd& values);

/// Where the tip is.
Eigen::Isometry3d forward_kinematics(const Arm& arm, const Eigen::VectorXd& values);

}  // namespace moivre
