// SPDX-License-Identifier: MIT
// Forward kinematics with its Jacobian, and Newton's method.
#include "polish.h"

#include <cmath>

#include "moivre/factorization/svd.h"

namespace moivre {
namespace {

using Velocity = Eigen::Matrix<double, 6, 1>;
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

constexpr int kMostIterations = 40;
constexpr int kMostDampedIterations = 200;
/// Directions whose singular value is smaller, beside the largest, move nothing but by rounding.
constexpr double kLeastMotion = 1e-10;
/// Radians, or arm's lengths, that one step may take.
constexpr double kLongestStep = 0.5;

struct Linearized {
  Velocity error;
  Jacobian jacobian;
};

Linearized linearized(const Arm& arm, const Eigen::Isometry3d& pose, const Eigen::VectorXd& q) {
  Linearized at;
  const auto n = static_cast<Eigen::Index>(arm.joints.size());
  at.jacobian = Jacobian::Zero(6, n);
  const std::vector<Eigen::Isometry3d> frames = joint_frames(arm, q);
  const Eigen::Isometry3d frame = frames.back() * arm.tool;
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Eigen::Vector3d axis = frames[i].linear() * arm.joints[i].axis;
    const Eigen::Vector3d lever = frame.translation() - frames[i].translation();
    if (arm.joints[i].is_slide) {
      at.jacobian.col(k).head<3>() = axis;  // per arm's length
    } else {
      at.jacobian.col(k) << axis.cross(lever) / arm.length, axis;
    }
  }
  const Eigen::Quaterniond turn(pose.linear() * frame.linear().transpose());
  const double sign = turn.w() < 0 ? -1 : 1;
  const double sine = turn.vec().norm();
  const double angle = 2 * std::atan2(sine, std::abs(turn.w()));
  const Eigen::Vector3d axis =
      sine > 0 ? Eigen::Vector3d(sign * turn.vec() / sine) : Eigen::Vector3d::Zero();
  at.error << (pose.translation() - frame.translation()) / arm.length, angle * axis;
  return at;
}

double size_of(const Velocity& error) {
  return std::max(error.head<3>().norm(), error.tail<3>().norm());
}

/// In radians and arm's lengths.
Eigen::VectorXd step_of(const Linearized& at, double damping) {
  const auto [U, sigma, V] = svd(at.jacobian, SingularVectors::thin);
  Eigen::VectorXd along = U.transpose() * at.error;
  for (Eigen::Index k = 0; k < sigma.size(); ++k) {
    const bool is_lost = sigma[k] <= kLeastMotion * sigma[0];
    along[k] = is_lost ? 0 : along[k] * sigma[k] / (sigma[k] * sigma[k] + damping);
  }
  Eigen::VectorXd step = V * along;
  const double longest = step.cwiseAbs().maxCoeff();
  if (longest > kLongestStep) step *= kLongestStep / longest;
  return step;
}

/// The same step in the joints' own units.
Eigen::VectorXd in_joints(const Arm& arm, Eigen::VectorXd step) {
  for (Eigen::Index k = 0; k < step.size(); ++k) {
    if (arm.joints[static_cast<std::size_t>(k)].is_slide) step[k] *= arm.length;
  }
  return step;
}

}  // namespace

Polished polish(const Arm& arm, const Eigen::Isometry3d& pose, const Eigen::VectorXd& start,
                bool is_damped) {
  constexpr double kFirstDamping = 1e-2, kMore = 4, kLess = 0.25;
  Polished best;
  best.values = start;
  Linearized at = linearized(arm, pose, start);
  best.residual = size_of(at.error);
  double damping = is_damped ? kFirstDamping : 0;
  const int most = is_damped ? kMostDampedIterations : kMostIterations;
  int failures = 0;
  while (best.iterations < most && best.residual > 0) {
    const Eigen::VectorXd next = best.values + in_joints(arm, step_of(at, damping));
    const Linearized there = linearized(arm, pose, next);
    const double residual = size_of(there.error);
    ++best.iterations;
    if (residual < best.residual) {
      const bool has_settled = residual > 0.5 * best.residual && residual < kReach;
      best.values = next;
      best.residual = residual;
      at = there;
      damping *= kLess;
      failures = 0;
      if (has_settled) break;
    } else {
      // At the last digits no step makes the error smaller.
      constexpr int kMostFailures = 8;
      if (best.residual < kReach || ++failures == kMostFailures) break;
      damping = std::max(damping * kMore, kFirstDamping * best.residual * best.residual);
    }
  }
  const Svd stretch = svd(at.jacobian, SingularVectors::full);
  best.smallest_singular_value = stretch.sigma[stretch.sigma.size() - 1];
  best.least_moving = stretch.V.col(stretch.V.cols() - 1);
  best.least_moved = stretch.U.col(stretch.sigma.size() - 1);
  // Of the two signs the one in which the largest joint value grows.
  Eigen::Index largest = 0;
  best.least_moving.cwiseAbs().maxCoeff(&largest);
  if (best.least_moving[largest] < 0) {
    best.least_moving = -best.least_moving;
    best.least_moved = -best.least_moved;
  }
  return best;
}

WeakestMotion weakest_motion(const Arm& arm, const Polished& closure) {
  return {in_joints(arm, closure.least_moving),
          {arm.length * closure.least_moved.head<3>(), closure.least_moved.tail<3>()}};
}

bool can_move(const Arm& arm, const Eigen::Isometry3d& pose, const Polished& closure) {
  constexpr double kSingular = 1e-6;
  constexpr double kProbe = 1e-2;
  if (closure.smallest_singular_value > kSingular) return false;
  const Eigen::VectorXd probe = closure.values + in_joints(arm, kProbe * closure.least_moving);
  const Polished there = polish(arm, pose, probe);
  const double moved = (there.values - closure.values).cwiseAbs().maxCoeff();
  const double meant = (probe - closure.values).cwiseAbs().maxCoeff();
  return there.residual <= kReach && moved > meant / 2;
}

}  // namespace moivre
