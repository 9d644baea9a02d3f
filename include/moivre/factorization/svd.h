// SPDX-License-Identifier: MIT
// Along which directions does a real matrix stretch, and how much? The singular value decomposition
// A = U diag(sigma) V^T.
//
// A: m x n, sigma: min(m, n) values, descending. By Jacobi's rotations, which know the small values
// best, up to kJacobiSize; else by bidiagonalization, which is a hundred times faster there. The
// one place that instantiates them.
// Edges: a matrix without rows or columns has no singular values, and its full vectors are
// identities.
// Not supported: complex matrices.
#pragma once

#include <Eigen/Core>

namespace moivre {

inline constexpr Eigen::Index kJacobiSize = 64;

enum class SingularVectors { thin, full };

struct Svd {
  Eigen::MatrixXd U;      ///< m x min(m, n) when thin, m x m when full
  Eigen::VectorXd sigma;  ///< descending
  Eigen::MatrixXd V;      ///< n x min(m, n) when thin, n x n when full
};
Svd svd(const Eigen::MatrixXd& A, SingularVectors vectors);

/// n x n, the last columns are the directions that A sees least; U is not computed.
Eigen::MatrixXd right_singular_vectors(const Eigen::MatrixXd& A);

/// Without vectors bidiagonalization pays from 16 rows or columns on.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& A);

}  // namespace moivre
