// SPDX-License-Identifier: MIT
// Gauss-Newton across directions that are kept.
#include "set_place.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "least_motion.h"

namespace moivre {

Eigen::VectorXd in_arms_lengths(const Arm& arm, Eigen::VectorXd difference) {
  for (Eigen::Index k = 0; k < difference.size(); ++k) {
    if (arm.joints[static_cast<std::size_t>(k)].is_slide) difference[k] /= arm.length;
  }
  return difference;
}

double apart(const Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return way_between(arm, a, b).norm();
}

SetPlace place_at(const Arm& arm, const Eigen::Isometry3d& pose, const Eigen::VectorXd& values) {
  SetPlace place;
  place.values = values;
  place.at = linearized(arm, pose, values);
  place.residual = size_of(place.at.error);
  return place;
}

Svd stretch_of(const SetPlace& place) {
  Svd stretch = svd(place.at.screws, SingularVectors::full);
  const Eigen::Index n = place.values.size();
  const Eigen::Index count = stretch.sigma.size();
  stretch.sigma.conservativeResize(n);
  stretch.sigma.tail(n - count).setZero();
  return stretch;
}

Velocity6<double> least_moved(const SetPlace& place) { return least_motion(place.at.screws).tip; }

namespace {

using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostJoints, kMostJoints>;

/// A singular value beside which a miss is far.
constexpr double kLongWay = kProbe / 10;

/// What is left to move by, in the joints' own coordinates.
Square across_of(const Eigen::MatrixXd& frozen) {
  const Eigen::Index n = frozen.rows();
  return Square::Identity(n, n) - frozen * frozen.transpose();
}

/// By the normal equations, where nothing is to be dropped: the step is short, or no direction
/// moves the tip so little that what is within the accuracy is far.
/// Screws: with as many columns as `across` has, faster where that is known.
template <class ScrewsOf, class SquareOf>
std::optional<JointVector<double>> step_across(const ScrewsOf& screws,
                                               const Velocity6<double>& error,
                                               const SquareOf& across, double accuracy) {
  constexpr double kIndependent = 1e-8;
  const ScrewsOf free = screws * across;
  const double size = free.squaredNorm();
  SquareOf gram = free.transpose() * free;
  // What is kept: 1 - across is a projection.
  gram += size * (SquareOf::Identity(gram.rows(), gram.cols()) - across);
  const Eigen::LDLT<SquareOf> ldlt(gram);
  if (!(ldlt.vectorD().minCoeff() > kIndependent * size)) return std::nullopt;
  const JointVector<double> along = free.transpose() * error;
  const JointVector<double> step = ldlt.solve(along);
  if (step.norm() <= kLongWay) return step;
  // 1 / sigma^2 <= |G^-1| for the smallest sigma.
  const SquareOf inverse = ldlt.solve(SquareOf::Identity(gram.rows(), gram.cols()));
  const double of_miss = accuracy / kLongWay;
  if (!(of_miss * of_miss * inverse.norm() < 1)) return std::nullopt;
  return step;
}

std::optional<JointVector<double>> step_across(const Linearized& at, const Square& across,
                                               double accuracy) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  if (across.cols() != 6) return step_across(at.screws, at.error, across, accuracy);
  return step_across(Matrix6(at.screws), at.error, Matrix6(across), accuracy);
}

/// Without the directions that rounding makes, or in which the miss is within the accuracy and far.
JointVector<double> step_of(const Linearized& at, const Square& across, double accuracy) {
  constexpr double kLost = 1e-13;
  const Svd stretch = svd(at.screws * across, SingularVectors::thin);
  Eigen::VectorXd along = stretch.U.transpose() * at.error;
  for (Eigen::Index i = 0; i < along.size(); ++i) {
    const double miss = std::abs(along[i]);
    const bool is_lost = stretch.sigma[i] <= kLost * stretch.sigma[0] ||
                         (miss <= accuracy && miss > kLongWay * stretch.sigma[i]);
    along[i] = is_lost ? 0 : along[i] / stretch.sigma[i];
  }
  return across * (stretch.V * along);
}

}  // namespace

SetPlace settled(const Arm& arm, const Eigen::Isometry3d& pose, Eigen::VectorXd values,
                 const Eigen::MatrixXd& frozen, double accuracy) {
  constexpr int kMost = 40;
  constexpr double kLongest = 0.2, kSettled = 1e-13, kShare = 1e-3;
  const double enough = std::max(kSettled, kShare * accuracy);
  const Square across = across_of(frozen);
  SetPlace place = place_at(arm, pose, values);
  for (int k = 0; k < kMost; ++k) {
    const auto plain = step_across(place.at, across, accuracy);
    JointVector<double> step = plain ? *plain : step_of(place.at, across, accuracy);
    const double size = step.cwiseAbs().maxCoeff();
    if (size > kLongest) step *= kLongest / size;
    place = place_at(arm, pose, place.values + in_joints<double>(arm, step));
    if (size < enough) break;
  }
  return place;
}

std::optional<SetPlace> moved(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& from,
                              const Eigen::VectorXd& direction, double step, double accuracy) {
  const Eigen::VectorXd there = from.values + in_joints<double>(arm, step * direction);
  SetPlace place = settled(arm, pose, there, direction, accuracy);
  if (!(place.residual <= accuracy)) return std::nullopt;
  const Eigen::VectorXd gone = place.values - from.values;
  const Eigen::VectorXd meant = there - from.values;
  if ((gone - meant).cwiseAbs().maxCoeff() > std::abs(step)) return std::nullopt;
  return place;
}

std::optional<SetPlace> place_between(const Arm& arm, const Eigen::Isometry3d& pose,
                                      const SetPlace& place, const Eigen::VectorXd& gone,
                                      double accuracy) {
  constexpr double kBow = 0.1;
  const Eigen::VectorXd half = place.values + in_joints<double>(arm, gone / 2);
  SetPlace between = settled(arm, pose, half, gone.normalized(), accuracy);
  const double bow = in_arms_lengths(arm, between.values - half).norm();
  if (!(between.residual <= accuracy && bow <= kBow * gone.norm())) return std::nullopt;
  return between;
}

bool leads_to(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& place,
              const Eigen::VectorXd& gone, double accuracy) {
  return place_between(arm, pose, place, gone, accuracy).has_value();
}

}  // namespace moivre
