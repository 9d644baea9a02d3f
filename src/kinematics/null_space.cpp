// SPDX-License-Identifier: MIT
// How is a null space found? The last right singular vectors, as many as the rank leaves over.
#include "moivre/kinematics/null_space.h"

#include "moivre/kinematics/linear.h"
#include "moivre/numeric/svd.h"

namespace moivre {

using Eigen::MatrixXd;

MatrixXd null_space(const MatrixXd& A) {
  if (A.rows() == 0 || A.cols() == 0) return MatrixXd::Identity(A.cols(), A.cols());
  const Eigen::Index freedoms = A.cols() - numerical_rank(A);
  return right_singular_vectors(A).rightCols(freedoms);
}

MatrixXd left_null_space(const MatrixXd& A) { return null_space(A.transpose()); }

}  // namespace moivre
