// SPDX-License-Identifier: MIT
// Steps that take imaginary parts away, and Gauss-Newton back to the pose. A complex matrix A + i B
// as the real one (A, -B; B, A), whose singular values are each there twice.
#include "complex_set.h"

#include <algorithm>
#include <cmath>

#include "approach.h"
#include "moivre/factorization/svd.h"
#include "set_place.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A complex posture near a set.
struct ComplexPlace {
  JointVector<Complex> values;
  VectorXd error;  ///< real parts, then imaginary ones
  Screws<Complex> screws;
};

MatrixXd as_real(const Screws<Complex>& screws) {
  const Index n = screws.cols();
  MatrixXd real(12, 2 * n);
  real << screws.real(), -screws.imag(), screws.imag(), screws.real();
  return real;
}

ComplexPlace complex_place_at(const Arm& arm, const Placement<Complex>& pose,
                              const JointVector<Complex>& values) {
  const TipMotion<Complex> motion = tip_motion<Complex>(arm, values);
  const Velocity6<Complex> error = small_difference<Complex>(arm, pose, motion.tip);
  ComplexPlace place{values, VectorXd(12), motion.screws};
  place.error << error.real(), error.imag();
  return place;
}

JointVector<Complex> as_complex(const VectorXd& step) {
  const Index n = step.size() / 2;
  JointVector<Complex> whole(n);
  for (Index k = 0; k < n; ++k) whole[k] = {step[k], step[n + k]};
  return whole;
}

/// Towards the pose, without directions that rounding makes, or in which the miss is within the
/// accuracy and far.
VectorXd step_to_pose(const ComplexPlace& place, double accuracy) {
  constexpr double kLost = 1e-13, kLongWay = kProbe / 10;
  const Svd stretch = svd(as_real(place.screws), SingularVectors::thin);
  const VectorXd& sigma = stretch.sigma;
  VectorXd along = stretch.U.transpose() * place.error;
  for (Index k = 0; k < sigma.size(); ++k) {
    const double miss = std::abs(along[k]);
    const bool is_lost =
        sigma[k] <= kLost * sigma[0] || (miss <= accuracy && miss > kLongWay * sigma[k]);
    along[k] = is_lost ? 0 : along[k] / sigma[k];
  }
  return stretch.V * along;
}

/// Nothing where the pose is not held near by.
std::optional<ComplexPlace> back_to_pose(const Arm& arm, const Placement<Complex>& pose,
                                         const JointVector<Complex>& values, double accuracy) {
  constexpr int kMost = 8;
  constexpr double kClearly = 0.1;
  ComplexPlace place = complex_place_at(arm, pose, values);
  const auto miss = [&] { return place.error.cwiseAbs().maxCoeff(); };
  double gone = 0;
  for (int k = 0; k < kMost && !(miss() <= kClearly * accuracy); ++k) {
    const VectorXd step = step_to_pose(place, accuracy);
    gone += step.norm();
    if (!(gone <= 2 * kStep)) return std::nullopt;
    place = complex_place_at(arm, pose, place.values + in_joints<Complex>(arm, as_complex(step)));
    if (step.norm() < accuracy) break;
  }
  if (!(miss() <= accuracy)) return std::nullopt;
  return place;
}

VectorXd imaginary_parts(const Arm& arm, const JointVector<Complex>& values) {
  return in_arms_lengths(arm, values.imag());
}

/// Along what hardly moves the tip, so that imaginary parts become less; no longer than a step.
VectorXd step_to_real(const Arm& arm, const ComplexPlace& place, double accuracy) {
  constexpr double kReachesFar = 0.05, kDependent = 0.1;
  const Index n = place.values.size();
  const Svd stretch = svd(as_real(place.screws), SingularVectors::full);
  Index weak = 0;
  for (Index k = 0; k < 2 * n; ++k) {
    const double sigma = k < stretch.sigma.size() ? stretch.sigma[k] : 0;
    if (sigma <= accuracy / kReachesFar) ++weak;
  }
  const MatrixXd ways = stretch.V.rightCols(weak);
  if (weak == 0) return VectorXd::Zero(2 * n);
  const Svd of_imaginary = svd(ways.bottomRows(n), SingularVectors::thin);
  VectorXd along = of_imaginary.U.transpose() * -imaginary_parts(arm, place.values);
  for (Index k = 0; k < along.size(); ++k) {
    const double sigma = of_imaginary.sigma[k];
    along[k] = sigma < kDependent ? 0 : along[k] / sigma;
  }
  const VectorXd step = ways * (of_imaginary.V * along);
  return step * std::min(1.0, kStep / std::max(step.norm(), 1e-300));
}

}  // namespace

std::optional<VectorXd> real_place_of(const Arm& arm, const Eigen::Isometry3d& pose,
                                      const JointVector<Complex>& from, double accuracy) {
  // Where imaginary parts are 12, an angle is infinite (approach.cpp).
  constexpr int kMost = 1000, kHalvings = 4;
  constexpr double kLess = 0.9, kNearlyReal = 1e-2;
  const Placement<Complex> at = complex_placement(pose);
  auto place = back_to_pose(arm, at, from, accuracy);
  if (!place) return std::nullopt;
  double size = imaginary_parts(arm, place->values).norm();
  for (int k = 0; k < kMost && size > 0; ++k) {
    const VectorXd step = step_to_real(arm, *place, accuracy);
    // What is left is not along the set.
    if (step.norm() < (1 - kLess) * size && step.norm() < kStep / 2) break;
    std::optional<ComplexPlace> next;
    double share = 1;
    for (int h = 0; h <= kHalvings; ++h, share /= 2) {
      const VectorXd gone = share * step;
      next = back_to_pose(arm, at, place->values + in_joints<Complex>(arm, as_complex(gone)),
                          accuracy);
      if (next && imaginary_parts(arm, next->values).norm() < size) break;
      next.reset();
    }
    if (!next) break;
    place = std::move(next);
    size = imaginary_parts(arm, place->values).norm();
  }
  if (size > kNearlyReal) return std::nullopt;
  const SetPlace real =
      settled(arm, pose, place->values.real(), MatrixXd(place->values.size(), 0), accuracy);
  if (!(real.residual <= accuracy) || apart(arm, real.values, place->values.real()) > kStep) {
    return std::nullopt;
  }
  return real.values;
}

}  // namespace moivre
