// SPDX-License-Identifier: MIT
// How is a null space found? The last right singular vectors, as many as the rank leaves over.
#include "moivre/kinematics/null_space.h"

#include <Eigen/Core>

#include "moivre/factorization/qr.h"
#include "moivre/factorization/svd.h"

namespace moivre {

using Eigen::MatrixXd;

MatrixXd null_space(const MatrixXd& A, double tolerance) {
  if (A.rows() == 0 || A.cols() == 0) return MatrixXd::Identity(A.cols(), A.cols());
  const Eigen::Index freedoms = A.cols() - numerical_rank(A, tolerance);
  if (freedoms == 0) return MatrixXd(A.cols(), 0);
  return right_singular_vectors(A).rightCols(freedoms);
}

MatrixXd null_space_basis(const MatrixXd& A) {
  if (A.rows() == 0 || A.cols() == 0) return MatrixXd::Identity(A.cols(), A.cols());
  const Eigen::Index freedoms = A.cols() - numerical_rank(A);
  // A S y = 0 with columns brought to unit length, so that units of length do not matter; x = S y.
  const Eigen::VectorXd lengths = A.colwise().norm().transpose();
  const Eigen::VectorXd scale =
      lengths.unaryExpr([](double length) { return length > 0 ? 1 / length : 1.0; });
  const MatrixXd scaled = scale.asDiagonal() * A.transpose();
  return scale.asDiagonal() * PivotedQr<double>(scaled).last_columns_of_Q(freedoms);
}

Eigen::VectorXd shortest_direction(const MatrixXd& A) {
  return right_singular_vectors(A).rightCols(1);
}

MatrixXd left_null_space(const MatrixXd& A, double tolerance) {
  return null_space(A.transpose(), tolerance);
}

}  // namespace moivre
