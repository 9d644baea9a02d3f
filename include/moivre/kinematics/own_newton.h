// SPDX-License-Identifier: MIT
// Does Newton-Raphson find a zero of one's own function from this guess? q+ = q + dq, J dq = -f,
// iteration by iteration.
//
//   f: R^n -> R^m, J = df/dq, m x n; without a J it is taken by central differences
// Steps are solved as kinematics/linear.h chooses: LU where J is square and regular, least squares
// where m > n, least |dq| where m < n.
// A row's residual counts relative to |J_i| |q|, the change of f_i by which rounding of q shows,
// |q| being 1 at least.
// Statuses, iterations and ranks are those of newton() on Phi (kinematics/newton.h). What f or J
// throws is thrown to the caller.
// Not supported: damping, held coordinates, weights.
#pragma once

#include <functional>

#include "moivre/kinematics/newton.h"

namespace moivre {

struct OwnFunction {
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> value;     ///< f, m
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian;  ///< J, m x n; may be empty
  /// n, which a guess must have: f itself cannot tell, and reads behind the end of one that is too
  /// short. 0: as many as the guess has.
  Eigen::Index unknowns = 0;
};

struct OwnNewtonOptions {
  double residual_tolerance = 1e-13;  ///< on NewtonResult::scaled_residual
  int maximum_iterations = 50;
};

/// Throws InvalidInput, with every broken rule, where there is no f, the guess is empty, not finite
/// or has not f.unknowns entries, f or J has a size of its own at some q, or an option makes no
/// sense.
NewtonResult newton(const OwnFunction& f, const Eigen::VectorXd& guess,
                    const OwnNewtonOptions& options = {});

}  // namespace moivre
