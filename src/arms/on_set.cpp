// SPDX-License-Identifier: MIT
// Is a posture on a set: by the relations of a plane, between the samples of a curve, or by a walk
// on a surface.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "moivre/arms/arm_closures.h"
#include "moivre/arms/rules.h"
#include "moivre/numeric/invalid_input.h"
#include "set_place.h"

namespace moivre {
namespace {

/// The places of a set's samples that are tried, each this far from the others.
constexpr int kTargets = 3;
constexpr double kTargetsApart = 0.5;

/// Goes from a place to a sample along what does not move the tip. False where it does not come
/// nearer, or leaves the pose.
bool walks_to(const Arm& arm, const Eigen::Isometry3d& pose, SetPlace here,
              const Eigen::VectorXd& sample, int dimension, double accuracy) {
  constexpr int kMost = 200;
  constexpr double kTurnedAway = 0.1;
  for (int k = 0; k < kMost; ++k) {
    const Eigen::VectorXd to = way_between(arm, here.values, sample);
    if (to.norm() < kStep) return to.norm() < kStep / 10 || leads_to(arm, pose, here, to, accuracy);
    const Eigen::MatrixXd tangent = stretch_of(here).V.rightCols(dimension);
    const Eigen::VectorXd along = tangent * (tangent.transpose() * to);
    if (along.norm() < kTurnedAway * to.norm()) return false;
    const double step = std::min(2 * kStep, along.norm());
    auto next = moved(arm, pose, here, along.normalized(), step, accuracy);
    if (!next) return false;
    here = std::move(*next);
  }
  return false;
}

/// A surface is known by samples that are far apart: of it is what one can walk to them from.
bool is_on_surface(const Arm& arm, const SelfMotion& motion, const Eigen::VectorXd& values,
                   double within) {
  constexpr double kAllowance = 2;
  const Eigen::Isometry3d pose = forward_kinematics(arm, motion.values);
  const double accuracy = std::max(kReach, kAllowance * motion.misfit);
  const SetPlace here = settled(arm, pose, values, Eigen::MatrixXd(values.size(), 0), accuracy);
  if (!(here.residual <= accuracy) || apart(arm, here.values, values) > within) return false;
  std::vector<Eigen::VectorXd> targets;
  for (int k = 0; k < kTargets; ++k) {
    const Eigen::VectorXd* nearest = nullptr;
    for (const Eigen::VectorXd& sample : motion.samples) {
      const bool is_tried = std::any_of(
          targets.begin(), targets.end(),
          [&](const Eigen::VectorXd& one) { return apart(arm, one, sample) < kTargetsApart; });
      if (is_tried) continue;
      const bool is_nearer =
          nearest == nullptr || apart(arm, sample, values) < apart(arm, *nearest, values);
      if (is_nearer) nearest = &sample;
    }
    if (nearest == nullptr) return false;
    if (walks_to(arm, pose, here, *nearest, motion.dimension, accuracy)) return true;
    targets.push_back(*nearest);
  }
  return false;
}

/// Between two samples a curve leaves its chord by a little.
bool passes_by(const Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b,
               const Eigen::VectorXd& values, double within) {
  constexpr double kBowOfChord = 0.1;
  const double most = std::max(within, kBowOfChord * kStep);
  JointVector<double> side(a.size()), to(a.size());
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    side[k] = joint_way(arm, a, b, k);
    to[k] = joint_way(arm, a, values, k);
    if (std::abs(to[k]) > std::abs(side[k]) + most) return false;
  }
  const double along = std::clamp(to.dot(side) / std::max(side.squaredNorm(), 1e-300), 0.0, 1.0);
  const double bow = kBowOfChord * std::min(kStep, side.norm());
  return (to - along * side).norm() < std::max(within, bow);
}

}  // namespace

bool is_on(const Arm& arm, const SelfMotion& motion, const Eigen::VectorXd& values, double within) {
  constexpr double kStandsStill = 5e-3;
  require_values(arm, values);
  const double near_plane = within;
  if (!motion.relations.empty()) {
    const Eigen::VectorXd away = way_between(arm, motion.values, values);
    // Joints that no relation names stand still.
    Eigen::VectorXd named = Eigen::VectorXd::Zero(values.size());
    bool holds = true;
    for (const JointRelation& relation : motion.relations) {
      named += relation.factors.cwiseAbs();
      double miss = 0;
      for (Eigen::Index k = 0; k < values.size(); ++k) {
        const bool is_slide = arm.joints[static_cast<std::size_t>(k)].is_slide;
        miss += relation.factors[k] * away[k] * (is_slide ? arm.length : 1);
      }
      holds = holds && std::abs(std::remainder(miss, 2 * std::numbers::pi)) < near_plane;
    }
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      const bool moves =
          named[k] > 0 || motion.directions.row(k).cwiseAbs().maxCoeff() > kStandsStill;
      holds = holds && (moves || std::abs(away[k]) < near_plane);
    }
    return holds;
  }
  if (motion.dimension > 1) return is_on_surface(arm, motion, values, within);
  for (std::size_t k = motion.closes ? 0 : 1; k < motion.samples.size(); ++k) {
    const Eigen::VectorXd& a = k > 0 ? motion.samples[k - 1] : motion.samples.back();
    if (passes_by(arm, a, motion.samples[k], values, within)) return true;
  }
  return false;
}

PoseMisfit misfit_of(const Arm& arm, const Eigen::Isometry3d& pose, const Eigen::VectorXd& values) {
  require_values(arm, values);
  const Velocity6<double> error = linearized(arm, workable_pose(pose, "the pose"), values).error;
  return {arm.length * error.head<3>().norm(), error.tail<3>().norm()};
}

bool contains(const Arm& arm, const ArmResult& result, const SelfMotion& motion,
              const Eigen::VectorXd& values, double within) {
  if (!(within >= 0) || !std::isfinite(within)) {
    throw InvalidInput("within: metres and radians, 0 or more and finite");
  }
  const PoseMisfit miss = misfit_of(arm, result.pose, values);
  const double most =
      within > 0 ? within / std::min(1.0, arm.length) : std::max(result.accuracy, motion.misfit);
  if (std::max(miss.position / arm.length, miss.rotation) > most) return false;
  // Where closures meet the tip is missed by the square of the way. Samples tell no more than they
  // are apart.
  return is_on(arm, motion, values, std::min(std::sqrt(std::max(most, kReach)), kStep));
}

}  // namespace moivre
