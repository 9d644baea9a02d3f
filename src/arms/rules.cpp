// SPDX-License-Identifier: MIT
// Are an arm's axes, transforms and limits, joint values and poses what they must be?
#include "moivre/arms/rules.h"

#include <cmath>

#include "exact_motion.h"
#include "moivre/arms/poses.h"
#include "moivre/factorization/svd.h"
#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

/// As far as rounding takes a rotation from orthonormal.
constexpr double kRounding = 1e-12;

double error_of_rotation(const Eigen::Matrix3d& R) {
  return (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

bool has_last_row(const Eigen::Isometry3d& pose) {
  return pose.matrix().row(3) == Eigen::RowVector4d(0, 0, 0, 1);
}

/// Clauses behind the pose's name.
std::vector<std::string> faults_of(const Eigen::Isometry3d& pose, double most) {
  if (!pose.matrix().allFinite()) return {"has a number that is not finite"};
  std::vector<std::string> faults;
  const Eigen::Vector3d place = pose.translation();
  if (!(place.cwiseAbs().maxCoeff() <= kLargestSize)) {
    faults.emplace_back("is further away than 1e50");
  }
  if (!has_last_row(pose)) faults.emplace_back("must have 0 0 0 1 as its last row");
  const Eigen::Matrix3d R = pose.linear();
  if (!(error_of_rotation(R) <= most)) {
    faults.emplace_back("has no rotation: its columns are not perpendicular and of length 1");
  } else if (R.determinant() < 0) {
    faults.emplace_back("has a mirrored rotation, a left-handed frame");
  }
  return faults;
}

bool is_displacement(const ExactPointer& g) {
  return g && dot(g->q, g->q) != 0 && dot(g->q, g->g) == 0;
}

void check_joint(const ArmJoint& joint, std::vector<std::string>& broken) {
  const std::string name = "joint '" + joint.name + "' ";
  for (const std::string& fault : faults_of(joint.before, kRounding)) {
    broken.push_back("the displacement before " + name + fault);
  }
  const bool is_unit = joint.axis.allFinite() && std::abs(joint.axis.norm() - 1) <= kRounding;
  if (!is_unit) broken.push_back(name + "needs an axis of length 1");
  if (!is_displacement(joint.exact_before) || !joint.step || largest_part(*joint.step) == 0) {
    broken.push_back(name + "needs exact displacements (make_arm() makes them)");
  }
  if (!(joint.exact_length > 0) || !is_workable(joint.exact_length)) {
    broken.push_back(name + "needs an exact_length above 0");
  }
  if (!joint.limits) return;
  const bool is_finite = is_workable(joint.limits->lower) && is_workable(joint.limits->upper);
  if (!is_finite || joint.limits->lower > joint.limits->upper) {
    broken.push_back(name + "needs finite limits, the lower one first");
  }
}

}  // namespace

std::vector<std::string> broken_rules(const Arm& arm) {
  std::vector<std::string> broken;
  constexpr std::size_t kMostJoints = 6;
  if (arm.joints.empty() || arm.joints.size() > kMostJoints) {
    broken.push_back("an arm has one to six joints, not " + std::to_string(arm.joints.size()));
  }
  for (const ArmJoint& joint : arm.joints) check_joint(joint, broken);
  for (const std::string& fault : faults_of(arm.tool, kRounding)) {
    broken.push_back("the tool " + fault);
  }
  if (!is_displacement(arm.exact_tool)) broken.emplace_back("the tool needs an exact displacement");
  if (!(arm.length > 0) || !is_workable(arm.length)) {
    broken.emplace_back("an arm's length is above 0");
  }
  return broken;
}

void require_unbroken(const Arm& arm) { require_unbroken(broken_rules(arm)); }

void require_values(const Arm& arm, const Eigen::VectorXd& values) {
  if (static_cast<std::size_t>(values.size()) != arm.joints.size()) {
    throw InvalidInput("the arm has " + std::to_string(arm.joints.size()) +
                       " joints, the values are " + std::to_string(values.size()));
  }
  if (!values.allFinite()) throw InvalidInput("a joint's value is not finite");
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& R) {
  const Svd parts = svd(R, SingularVectors::full);
  return parts.U * parts.V.transpose();
}

Eigen::Isometry3d workable_pose(const Eigen::Isometry3d& pose, const std::string& name) {
  std::vector<std::string> broken;
  for (const std::string& fault : faults_of(pose, kRoundedBy)) broken.push_back(name + " " + fault);
  require_unbroken(broken);
  const Eigen::Matrix3d R = pose.linear();
  if (error_of_rotation(R) <= kRounding) return pose;
  Eigen::Isometry3d nearest = pose;
  nearest.linear() = nearest_rotation(R);
  return nearest;
}

}  // namespace moivre
