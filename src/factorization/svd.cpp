// SPDX-License-Identifier: MIT
// How is a singular value decomposition computed? Jacobi's rotations for small matrices,
// bidiagonalization for large ones.
#include "moivre/factorization/svd.h"

#include <Eigen/SVD>
#include <algorithm>

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The screws of six joints, by far the most: faster where the size is known.
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// At 50 rows bidiagonalization without vectors takes a twentieth of the time.
constexpr Index kJacobiValues = 16;

Index smaller_side(const MatrixXd& A) { return std::min(A.rows(), A.cols()); }

template <class Decomposition>
Svd taken_from(const Decomposition& decomposition) {
  return {decomposition.matrixU(), decomposition.singularValues(), decomposition.matrixV()};
}

}  // namespace

Svd svd(const MatrixXd& A, SingularVectors vectors) {
  if (A.size() == 0) {
    const bool full = vectors == SingularVectors::full;
    return {MatrixXd::Identity(A.rows(), full ? A.rows() : 0), VectorXd(),
            MatrixXd::Identity(A.cols(), full ? A.cols() : 0)};
  }
  const unsigned int wanted = vectors == SingularVectors::full
                                  ? Eigen::ComputeFullU | Eigen::ComputeFullV
                                  : Eigen::ComputeThinU | Eigen::ComputeThinV;
  if (A.rows() == 6 && A.cols() == 6) {
    return taken_from(Eigen::JacobiSVD<Matrix6>(A, Eigen::ComputeFullU | Eigen::ComputeFullV));
  }
  if (smaller_side(A) <= kJacobiSize) return taken_from(Eigen::JacobiSVD<MatrixXd>(A, wanted));
  return taken_from(Eigen::BDCSVD<MatrixXd>(A, wanted));
}

MatrixXd right_singular_vectors(const MatrixXd& A) {
  if (A.size() == 0) return MatrixXd::Identity(A.cols(), A.cols());
  if (smaller_side(A) <= kJacobiSize) {
    return Eigen::JacobiSVD<MatrixXd>(A, Eigen::ComputeFullV).matrixV();
  }
  return Eigen::BDCSVD<MatrixXd>(A, Eigen::ComputeFullV).matrixV();
}

VectorXd singular_values(const MatrixXd& A) {
  if (A.size() == 0) return VectorXd();
  if (smaller_side(A) <= kJacobiValues) return Eigen::JacobiSVD<MatrixXd>(A).singularValues();
  return Eigen::BDCSVD<MatrixXd>(A).singularValues();
}

}  // namespace moivre
