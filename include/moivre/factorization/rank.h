// SPDX-License-Identifier: MIT
// What rank has a matrix at least, of which only an approximation is known? That of columns that
// stay independent whatever the error.
//
//   |A - B|_F <= e and sigma_min(A_1) > e for r columns A_1 of A: then B has rank r at least
//   [Stewart73]
//
// The columns are chosen by pivoting, A P = Q R, and sigma_min(R_1) >= 1 / |R_1^-1|_F. A: m x n,
// complex.
// Edges: a matrix without rows or columns has rank 0. Not supported: an upper bound, which no
// approximation gives.
#pragma once

#include <Eigen/Core>

namespace moivre {

/// Of every matrix within `error` >= 0 of A, in the Frobenius norm; rounding is taken into account.
Eigen::Index least_rank(const Eigen::MatrixXcd& A, double error);

}  // namespace moivre
