// SPDX-License-Identifier: MIT
// Gauss-Newton across directions that are kept.
#include "set_place.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "least_motion.h"
#include "six_equations.h"

namespace moivre {

JointVector<double> in_arms_lengths(const Arm& arm, JointVector<double> difference) {
  for (Eigen::Index k = 0; k < difference.size(); ++k) {
    if (arm.joints[static_cast<std::size_t>(k)].is_slide) difference[k] /= arm.length;
  }
  return difference;
}

double apart(const Arm& arm, const JointValues& a, const JointValues& b) {
  return way_between(arm, a, b).norm();
}

SetPlace place_at(const Arm& arm, const Eigen::Isometry3d& pose,
                  const JointVector<double>& values) {
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

// By inverse iteration, where the next direction is as clear as that of a set.
Velocity6<double> least_moved(const SetPlace& place, const Velocity6<double>& nearby) {
  constexpr int kSteps = 4;
  constexpr double kClear = 1e-10, kTurnsBy = 1e-3, kSettled = 1e-10;
  if (place.at.screws.cols() != 6) return least_moved(place);
  const Matrix6d backwards = place.at.screws.transpose();
  const Matrix6d gram = gram_of(backwards);
  const SixFactors factors = factors_of(gram);
  if (!(factors.least > kClear * gram.trace())) return least_moved(place);
  Velocity6<double> least = nearby;
  double turned = 1;
  for (int k = 0; k < kSteps; ++k) {
    const Velocity6<double> next = solution_of(factors, least).normalized();
    const double turns = (next - least).norm();
    least = next;
    // What was left turns by a share of what it was: it is of the others, if that is small.
    if (k > 0 && turns > kTurnsBy * turned + kSettled) break;
    if (turns <= kSettled) return least;
    turned = turns;
  }
  return least_moved(place);
}

namespace {

using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostJoints, kMostJoints>;
using Frozen = Eigen::Ref<const Eigen::MatrixXd>;  // orthonormal columns

/// A singular value relative to which a miss is far.
constexpr double kLongWay = kProbe / 10;

/// Of the largest pivot, or of the sum of the squares of what moves the tip.
constexpr double kIndependent = 1e-8;
constexpr int kInverseSteps = 6;

// By the normal equations: the step is short, or no direction, or one alone, moves the tip so
// little that what is within the accuracy is far. What is kept has the projection frozen frozen^T.

/// Nothing where they do not tell.
std::optional<Velocity6<double>> step_across_six(const Linearized& at, const Frozen& frozen,
                                                 double accuracy) {
  const Matrix6d screws = at.screws;
  Matrix6d free = screws;
  Matrix6d kept = Matrix6d::Zero();
  for (Eigen::Index k = 0; k < frozen.cols(); ++k) {
    const Velocity6<double> way = frozen.col(k);
    const Velocity6<double> moved = free * way;  // columns are orthogonal
    for (Eigen::Index i = 0; i < 6; ++i) {
      free.col(i) -= way[i] * moved;
      kept.col(i) += way[i] * way;
    }
  }
  const double size = free.squaredNorm();
  const Matrix6d gram = gram_of(free) + size * kept;
  const SixFactors factors = factors_of(gram);
  if (!(factors.least > kIndependent * size)) return std::nullopt;
  const Velocity6<double> along = free.transpose() * at.error;
  const Velocity6<double> step = solution_of(factors, along);
  if (step.norm() <= kLongWay) return step;
  // One direction may be weak, by inverse iteration: the others are not, if no pivot is negative
  // without it and less by the bound's square.
  Velocity6<double> weak = step.normalized();
  for (int k = 0; k < kInverseSteps; ++k) weak = solution_of(factors, weak).normalized();
  const double bound = accuracy / kLongWay;
  Matrix6d others = gram + size * weak * weak.transpose();
  others.diagonal().array() -= bound * bound;
  if (!(factors_of(others).least > 0)) return std::nullopt;
  const Velocity6<double> moved = free * weak;
  const double square = moved.squaredNorm();
  const double miss = std::abs(moved.dot(at.error));  // relative to the singular value, |moved|
  const bool is_far = miss <= accuracy * std::sqrt(square) && miss > kLongWay * square;
  return is_far ? Velocity6<double>(step - weak.dot(step) * weak) : step;
}

std::optional<JointVector<double>> step_across(const Linearized& at, const Frozen& frozen,
                                               double accuracy) {
  if (at.screws.cols() == 6) {
    const auto step = step_across_six(at, frozen, accuracy);
    return step ? std::optional<JointVector<double>>(*step) : std::nullopt;
  }
  const Square kept = frozen * frozen.transpose();
  const Screws<double> free = at.screws - at.screws * kept;
  const double size = free.squaredNorm();
  const Square gram = free.transpose() * free + size * kept;
  const Eigen::LDLT<Square> ldlt(gram);
  if (!(ldlt.vectorD().minCoeff() > kIndependent * size)) return std::nullopt;
  const JointVector<double> along = free.transpose() * at.error;
  const JointVector<double> step = ldlt.solve(along);
  if (step.norm() <= kLongWay) return step;
  // 1 / sigma^2 <= |G^-1| for the smallest sigma.
  const Square inverse = ldlt.solve(Square::Identity(gram.rows(), gram.cols()));
  const double of_miss = accuracy / kLongWay;
  if (!(of_miss * of_miss * inverse.norm() < 1)) return std::nullopt;
  return step;
}

/// Without the directions that rounding makes, or in which the miss is within the accuracy and far.
JointVector<double> step_of(const Linearized& at, const Frozen& frozen, double accuracy) {
  constexpr double kLost = 1e-13;
  const Eigen::Index n = frozen.rows();
  const Square across = Square::Identity(n, n) - frozen * frozen.transpose();
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

SetPlace settled(const Arm& arm, const Eigen::Isometry3d& pose, const JointVector<double>& values,
                 const Frozen& frozen, double accuracy) {
  constexpr int kMost = 40;
  constexpr double kLongest = 0.2, kSettled = 1e-13, kShare = 1e-3, kCurved = 0.1;
  const double enough = std::max(kSettled, kShare * accuracy);
  JointVector<double> here = values;
  Linearized at = linearized(arm, pose, here);
  for (int k = 0; k < kMost; ++k) {
    const auto plain = step_across(at, frozen, accuracy);
    JointVector<double> step = plain ? *plain : step_of(at, frozen, accuracy);
    const double size = step.cwiseAbs().maxCoeff();
    if (size > kLongest) step *= kLongest / size;
    here += in_joints<double>(arm, step);
    if (size < enough) {  // so near the screws are the same
      at.error -= at.screws * step;
      break;
    }
    at = linearized(arm, pose, here);
    if (accuracy > kReach && size * size < kCurved * enough)
      break;  // the next step is as its square
  }
  return {here, size_of(at.error), at};
}

std::optional<SetPlace> moved(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& from,
                              const JointVector<double>& direction, double step, double accuracy) {
  const JointVector<double> there = from.values + in_joints<double>(arm, step * direction);
  SetPlace place = settled(arm, pose, there, direction, accuracy);
  if (!(place.residual <= accuracy)) return std::nullopt;
  if ((place.values - there).cwiseAbs().maxCoeff() > std::abs(step)) return std::nullopt;
  return place;
}

std::optional<SetPlace> place_between(const Arm& arm, const Eigen::Isometry3d& pose,
                                      const SetPlace& place, const JointVector<double>& gone,
                                      double accuracy) {
  constexpr double kBow = 0.1;
  const JointVector<double> half = place.values + in_joints<double>(arm, gone / 2);
  SetPlace between = settled(arm, pose, half, gone.normalized(), accuracy);
  const double bow = in_arms_lengths(arm, between.values - half).norm();
  if (!(between.residual <= accuracy && bow <= kBow * gone.norm())) return std::nullopt;
  return between;
}

bool leads_to(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& place,
              const JointVector<double>& gone, double accuracy) {
  return place_between(arm, pose, place, gone, accuracy).has_value();
}

}  // namespace moivre
