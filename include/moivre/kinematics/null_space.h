// SPDX-License-Identifier: MIT
// Which directions does a matrix map to zero? Orthonormal null spaces from the singular value
// decomposition, rank given by QR.
//
// A: m x n. The rank is kinematics/linear.h's, that of A with rows and columns brought to unit
// length; the null space is A's own.
// Edges: of full rank, and of no rows or columns, the null space has as many columns as are left, 0
// to n.
#pragma once

#include <Eigen/Core>

#include "moivre/kinematics/linear.h"

namespace moivre {

/// n x (n - rank), A N = 0, where `tolerance` is that of the rank.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& A, double tolerance = kRankTolerance);

/// As null_space, but the columns are only independent, not orthonormal: by QR, which is faster.
Eigen::MatrixXd null_space_basis(const Eigen::MatrixXd& A);

/// The unit vector that A shortens most, where it has columns of comparable length: of a matrix
/// that is singular but for rounding.
Eigen::VectorXd shortest_direction(const Eigen::MatrixXd& A);

/// m x (m - rank), N^T A = 0.
Eigen::MatrixXd left_null_space(const Eigen::MatrixXd& A, double tolerance = kRankTolerance);

}  // namespace moivre
