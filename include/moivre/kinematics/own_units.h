// SPDX-License-Identifier: MIT
// What rank has Phi_q, whatever unit lengths are typed in? Counted where lengths are measured by
// the mechanism's own.
//
//   J' = R^-1 J C,   R, C diagonal: of each row and coordinate 1, or a power of the mechanism's
//                    mean length (mechanism/phi.h)
// J: Phi_q, its first rows, or [Phi_q Phi_t]. A mechanism typed in micrometres has the rank and the
// singular poses of the same in metres.
// Solutions come back in the file's units.
#pragma once

#include <Eigen/Core>

#include "moivre/kinematics/linear.h"
#include "moivre/mechanism/phi.h"

namespace moivre {

/// The largest |v_k|, where a length counts in the mechanism's own; v: n
double largest_of(const Phi& phi, const Eigen::VectorXd& v);

/// J'
Eigen::MatrixXd in_own_units(const Phi& phi, const Eigen::MatrixXd& J);

/// That of J' (kinematics/linear.h).
Eigen::Index rank_of(const Phi& phi, const Eigen::MatrixXd& J, double tolerance = kRankTolerance);

/// Of Phi_q, through J'.
Factorization factorization_of(const Phi& phi, const Eigen::MatrixXd& J,
                               LinearOptions options = {});

/// n x (n - rank), orthonormal, J N = 0.
Eigen::MatrixXd null_space_of(const Phi& phi, const Eigen::MatrixXd& J,
                              double tolerance = kRankTolerance);

/// m x (m - rank), orthonormal, N^T J = 0.
Eigen::MatrixXd left_null_space_of(const Phi& phi, const Eigen::MatrixXd& J,
                                   double tolerance = kRankTolerance);

}  // namespace moivre
