// SPDX-License-Identifier: MIT
// Gauss-Newton across directions that are kept.
#include "set_place.h"

#include <algorithm>
#include <cmath>

#include "moivre/factorization/svd.h"
#include "polish.h"

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
  const Linearized at = linearized(arm, pose, values);
  const Svd stretch = svd(at.screws, SingularVectors::full);
  SetPlace place;
  place.values = values;
  place.residual = size_of(at.error);
  place.V = stretch.V;
  place.sigma = Eigen::VectorXd::Zero(values.size());
  place.sigma.head(stretch.sigma.size()) = stretch.sigma;
  place.error = at.error;
  place.least = stretch.U.col(stretch.sigma.size() - 1);
  return place;
}

SetPlace settled(const Arm& arm, const Eigen::Isometry3d& pose, Eigen::VectorXd values,
                 const Eigen::MatrixXd& frozen, double accuracy) {
  constexpr int kMost = 40;
  constexpr double kLost = 1e-9, kLongest = 0.2, kSettled = 1e-13, kLongWay = kProbe / 10;
  const Eigen::Index n = values.size();
  const Eigen::MatrixXd across = Eigen::MatrixXd::Identity(n, n) - frozen * frozen.transpose();
  for (int k = 0; k < kMost; ++k) {
    const Linearized at = linearized(arm, pose, values);
    const Svd stretch = svd(at.screws * across, SingularVectors::thin);
    Eigen::VectorXd along = stretch.U.transpose() * at.error;
    for (Eigen::Index i = 0; i < along.size(); ++i) {
      const double miss = std::abs(along[i]);
      const bool is_lost = stretch.sigma[i] <= kLost * stretch.sigma[0] ||
                           (miss <= accuracy && miss > kLongWay * stretch.sigma[i]);
      along[i] = is_lost ? 0 : along[i] / stretch.sigma[i];
    }
    Eigen::VectorXd step = across * (stretch.V * along);
    const double size = step.cwiseAbs().maxCoeff();
    if (size > kLongest) step *= kLongest / size;
    values += in_joints<double>(arm, step);
    if (size < kSettled) break;
  }
  return place_at(arm, pose, values);
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

bool leads_to(const Arm& arm, const Eigen::Isometry3d& pose, const SetPlace& place,
              const Eigen::VectorXd& gone, double accuracy) {
  constexpr double kBow = 0.1;
  const Eigen::VectorXd half = place.values + in_joints<double>(arm, gone / 2);
  const SetPlace between = settled(arm, pose, half, gone.normalized(), accuracy);
  return between.residual <= accuracy &&
         in_arms_lengths(arm, between.values - half).norm() <= kBow * gone.norm();
}

}  // namespace moivre
