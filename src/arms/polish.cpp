// SPDX-License-Identifier: MIT
// Forward kinematics with its Jacobian, and Newton's method.
#include "polish.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <optional>

#include "least_motion.h"
#include "moivre/factorization/svd.h"
#include "six_equations.h"

namespace moivre {
namespace {

constexpr int kMostIterations = 40;
constexpr int kMostDampedIterations = 200;
/// Directions whose singular value is smaller, beside the largest, move nothing but by rounding.
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
  constexpr double kIndependent = 1e-6;
  if (at.screws.cols() != 6) return std::nullopt;
  const SixSolved solved = solve_six(at.screws, at.error);
  if (!(solved.least > kIndependent * solved.largest)) return std::nullopt;
  return not_too_long(solved.x);
}

/// Least squares by the normal equations, where squares leave enough digits for a step.
std::optional<JointVector<double>> normal_step(const Linearized& at, double damping) {
  constexpr double kIndependent = 1e-8;
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

}  // namespace

Linearized linearized(const Arm& arm, const Eigen::Isometry3d& pose,
                      const JointVector<double>& values) {
  constexpr double kSmall = 1e-5;
  const TipMotion<double> motion = tip_motion<double>(arm, values);
  Linearized at;
  at.screws = motion.screws;
  const Eigen::Quaterniond turn(Eigen::Matrix3d(pose.linear() * motion.tip.R.transpose()));
  const double sign = turn.w() < 0 ? -1 : 1;
  const double sine = turn.vec().norm();
  // 2 arcsin(s) / s = 2 + s^2 / 3 + ...
  const double factor =
      sine < kSmall ? 2 + sine * sine / 3 : 2 * std::atan2(sine, std::abs(turn.w())) / sine;
  at.error << (pose.translation() - motion.tip.p) / arm.length, sign * factor * turn.vec();
  return at;
}

double size_of(const Velocity6<double>& error) {
  return std::max(error.head<3>().norm(), error.tail<3>().norm());
}

Polished polish(const Arm& arm, const Eigen::Isometry3d& pose, const JointVector<double>& start,
                bool is_damped) {
  constexpr double kFirstDamping = 1e-2, kMore = 4, kLess = 0.25;
  Polished best;
  best.values = start;
  Linearized at = linearized(arm, pose, start);
  best.residual = size_of(at.error);
  JointVector<double> here = start;
  double here_residual = best.residual;
  double damping = is_damped ? kFirstDamping : 0;
  const int most = is_damped ? kMostDampedIterations : kMostIterations;
  int failures = 0;
  while (best.iterations < most && here_residual > kLastBits) {
    const JointVector<double> step = step_of(at, damping);
    const JointVector<double> next = here + in_joints<double>(arm, step);
    const Linearized there = linearized(arm, pose, next);
    const double residual = size_of(there.error);
    ++best.iterations;
    if (residual < here_residual || contracts(at, step, damping, there.error)) {
      const bool has_settled = residual > 0.5 * here_residual && residual < kRoundingError;
      here = next;
      here_residual = residual;
      at = there;
      damping *= kLess;
      failures = 0;
      if (residual < best.residual) {
        best.values = here;
        best.residual = residual;
      }
      if (has_settled) break;
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
