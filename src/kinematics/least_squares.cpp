// SPDX-License-Identifier: MIT
// Damped steps (Levenberg, Marquardt): less damping behind a step that helps, more behind one that
// does not.
#include "moivre/kinematics/least_squares.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "moivre/kinematics/own_units.h"

namespace moivre {

Eigen::VectorXd least_squares_pose(const Phi& phi, const Eigen::VectorXd& guess, double t) {
  require_place(phi, guess, t);
  constexpr int kSteps = 60;
  constexpr double kAtRest = 1e-12;  // relative to the mechanism's size
  constexpr double kMostDamping = 1e12;
  const Eigen::VectorXd unit = phi.own_units();
  const Eigen::VectorXd row_unit = phi.own_row_units();
  const auto residual = [&](const Eigen::VectorXd& q) -> Eigen::VectorXd {
    return phi.value(q, t).cwiseQuotient(row_unit);
  };
  Eigen::VectorXd q = guess;
  Eigen::VectorXd r = residual(q);
  double damping = 1e-3;
  for (int step = 0; step < kSteps && damping < kMostDamping && r.allFinite();) {
    const Eigen::MatrixXd J = in_own_units(phi, phi.jacobian(q, t));
    Eigen::MatrixXd normal = J.transpose() * J;
    normal.diagonal().array() += damping;
    const Eigen::VectorXd move = normal.ldlt().solve(-J.transpose() * r);
    const Eigen::VectorXd next = q + unit.cwiseProduct(move);
    const Eigen::VectorXd left = residual(next);
    ++step;
    if (!(left.squaredNorm() < r.squaredNorm())) {
      damping *= 10;
      continue;
    }
    // At a whole turn the derivative by a rotation vector is singular, and least squares would end
    // there, at no pose.
    q = phi.has_long_rotation(next) ? phi.canonical(next) : next;
    r = left;
    damping = std::max(damping / 10, 1e-15);
    if (move.lpNorm<Eigen::Infinity>() <= kAtRest) break;
  }
  return q;
}

}  // namespace moivre
