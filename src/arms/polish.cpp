// SPDX-License-Identifier: MIT
// Forward kinematics with its Jacobian, and Newton's method.
#include "polish.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <optional>

#include "least_motion.h"
#include "moivre/factorization/svd.h"
#include "moivre/numeric/fused.h"
#include "six_equations.h"

namespace moivre {
namespace {

constexpr int kMostIterations = 40;
constexpr int kMostDampedIterations = 200;
/// Directions whose singular value is smaller, relative to the largest, move nothing but by
/// rounding.
constexpr double kLeastMotion = 1e-12;
/// What forward kinematics is wrong by: no step makes less of it.
constexpr double kLastBits = 1e-15;
/// Radians, or arm's lengths, that one step may take.
constexpr double kLongestStep = 0.5;

JointVector<double> not_too_long(JointVector<double> step) {
  const double longest = step.cwiseAbs().maxCoeff();
  if (longest > kLongestStep) step *= kLongestStep / longest;
  return step;
}

/// Newton's own step, where the screws are six and clearly independent.
std::optional<JointVector<double>> plain_step(const Linearized& at) {
  constexpr double kIndependent = 1e-9;
  if (at.screws.cols() != 6) return std::nullopt;
  const SixSolved solved = solve_six(at.screws, at.error);
  if (!(solved.least > kIndependent * solved.largest)) return std::nullopt;
  return not_too_long(solved.x);
}

/// Least squares by the normal equations, where squares leave enough digits for a step.
std::optional<JointVector<double>> normal_step(const Linearized& at, double damping) {
  constexpr double kIndependent = 1e-12;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostJoints, kMostJoints>;
  if (at.screws.cols() == 6) {
    const Matrix6d screws = at.screws;
    Matrix6d gram = gram_of(screws);
    gram.diagonal().array() += damping;
    const SixSolved solved = solve_symmetric_six(gram, screws.transpose() * at.error);
    if (!(solved.least > kIndependent * solved.largest)) return std::nullopt;
    return not_too_long(solved.x);
  }
  Square gram = at.screws.transpose() * at.screws;
  gram.diagonal().array() += damping;
  const Eigen::LDLT<Square> ldlt(gram);
  const auto pivots = ldlt.vectorD();
  if (!(pivots.minCoeff() > kIndependent * pivots.maxCoeff())) return std::nullopt;
  const JointVector<double> along = at.screws.transpose() * at.error;
  return not_too_long(ldlt.solve(along));
}

/// In radians and arm's lengths.
JointVector<double> step_of(const Linearized& at, double damping) {
  if (damping == 0) {
    if (const auto step = plain_step(at)) return *step;
  }
  if (const auto step = normal_step(at, damping)) return *step;
  const auto [U, sigma, V] = svd(at.screws, SingularVectors::thin);
  Eigen::VectorXd along = U.transpose() * at.error;
  for (Eigen::Index k = 0; k < sigma.size(); ++k) {
    const bool is_lost = sigma[k] <= kLeastMotion * sigma[0];
    along[k] = is_lost ? 0 : along[k] * sigma[k] / (sigma[k] * sigma[k] + damping);
  }
  const Eigen::VectorXd step = V * along;
  return not_too_long(step);
}

/// Along a curve on which the tip nearly stands a good step may miss the pose by more, since the
/// curve is bent: the next step tells. By the same screws it is shorter, by 1/e where many closures
/// meet.
bool contracts(const Linearized& at, const JointVector<double>& step, double damping,
               const Velocity6<double>& error_there) {
  constexpr double kContraction = 0.5;
  return step.cwiseAbs().maxCoeff() < kLongestStep &&
         step_of({error_there, at.screws}, damping).norm() < kContraction * step.norm();
}

/// a b^T: small enough to be written out.
Eigen::Matrix3d product_with_inverse(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  Eigen::Matrix3d result;
  for (Eigen::Index k = 0; k < 3; ++k) {
    result.col(k) = a.col(0) * b(k, 0) + a.col(1) * b(k, 1) + a.col(2) * b(k, 2);
  }
  return result;
}

/// Axis times angle.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
  constexpr double kSmall = 1e-3;
  const Eigen::Vector3d along(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double cosine = (R.trace() - 1) / 2;
  const double square = along.squaredNorm() / 4;  // of the sine
  if (cosine > 0 && square < kSmall * kSmall) {
    // arcsin(s) / s = 1 + s^2 / 6 + 3 s^4 / 40 + ...
    return (0.5 + square * (1.0 / 12 + square * 3 / 80)) * along;
  }
  if (cosine > 0) {
    const double sine = std::sqrt(square);
    return std::atan2(sine, cosine) / (2 * sine) * along;
  }
  const Eigen::Quaterniond turn(R);
  const double sine = turn.vec().norm();
  return std::copysign(2 * std::atan2(sine, std::abs(turn.w())) / sine, turn.w()) * turn.vec();
}

}  // namespace

Linearized linearized(const Arm& arm, const Eigen::Isometry3d& pose,
                      const JointVector<double>& values) {
  const TipMotion<double> motion = tip_motion<double>(arm, values);
  Linearized at;
  at.screws = motion.screws;
  fused([&] {
    const Eigen::Matrix3d turn = product_with_inverse(pose.linear(), motion.tip.R);
    at.error << (pose.translation() - motion.tip.p) * (1 / arm.length), rotation_vector(turn);
  });
  return at;
}

double size_of(const Velocity6<double>& error) {
  return std::max(error.head<3>().norm(), error.tail<3>().norm());
}

Polished polish(const Arm& arm, const Eigen::Isometry3d& pose, const JointVector<double>& start,
                bool is_damped) {
  constexpr double kFirstDamping = 1e-2, kMore = 4, kLess = 0.25;
  constexpr double kValley = 1e-3, kHardlyLess = 0.9;
  constexpr int kMostSlow = 20;
  Polished best;
  best.values = start;
  Linearized at = linearized(arm, pose, start);
  best.residual = size_of(at.error);
  JointVector<double> here = start;
  double here_residual = best.residual;
  double damping = is_damped ? kFirstDamping : 0;
  const int most = is_damped ? kMostDampedIterations : kMostIterations;
  int failures = 0, slow = 0;
  while (best.iterations < most && here_residual > kLastBits) {
    const JointVector<double> step = step_of(at, damping);
    const JointVector<double> next = here + in_joints<double>(arm, step);
    const Linearized there = linearized(arm, pose, next);
    const double residual = size_of(there.error);
    ++best.iterations;
    if (residual < here_residual || contracts(at, step, damping, there.error)) {
      const bool has_settled = residual > 0.5 * here_residual && residual < kRoundingError;
      // Far along a valley: of a set that the accuracy leaves open, or to where closures meet.
      slow = residual < kValley && residual > kHardlyLess * here_residual ? slow + 1 : 0;
      here = next;
      here_residual = residual;
      at = there;
      damping *= kLess;
      failures = 0;
      if (residual < best.residual) {
        best.values = here;
        best.residual = residual;
      }
      if (has_settled || slow == kMostSlow) break;
    } else {
      // At the last digits no step makes the error smaller.
      constexpr int kMostFailures = 8;
      if (here_residual < kRoundingError || ++failures == kMostFailures) break;
      damping = std::max(damping * kMore, kFirstDamping * here_residual * here_residual);
    }
  }
  if (here_residual > best.residual) at = linearized(arm, pose, best.values);
  const LeastMotion least = least_motion(at.screws);
  best.smallest_singular_value = least.singular_value;
  best.screws_square = at.screws.squaredNorm();
  best.least_moving = least.joints;
  best.least_moved = least.tip;
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
  return {in_joints<double>(arm, closure.least_moving),
          {arm.length * closure.least_moved.head<3>(), closure.least_moved.tail<3>()}};
}

}  // namespace moivre
