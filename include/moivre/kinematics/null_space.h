// SPDX-License-Identifier: MIT
// Which directions does a matrix not see? Orthonormal null spaces from the singular value decomposition, rank given by QR.
#pragma once

#include <Eigen/Dense>

namespace moivre {

/// n x (n - rank), A N = 0.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& A);

/// m x (m - rank), N^T A = 0.
Eigen::MatrixXd left_null_space(const Eigen::MatrixXd& A);

}  // namespace moivre
