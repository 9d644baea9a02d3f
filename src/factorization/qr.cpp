// SPDX-License-Identifier: MIT
// Eigen's factorizations, each instantiated here and nowhere else, and for matrices only: they are
// what takes a compiler longest.
#include "moivre/factorization/qr.h"

namespace moivre {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

template <class Matrix, class Vector>
Vector shortest(const Matrix& A, const Vector& b, double tolerance) {
  Eigen::CompleteOrthogonalDecomposition<Matrix> decomposition(A.rows(), A.cols());
  if (tolerance > kToRounding) decomposition.setThreshold(tolerance);
  return decomposition.compute(A).solve(Matrix(b));
}

}  // namespace

Qr::Qr(const MatrixXd& A) : qr_(A) {}

VectorXd Qr::solve(const VectorXd& b) const { return qr_.solve(MatrixXd(b)); }

VectorXd Qr::solve_transposed(const VectorXd& c) const {
  const MatrixXd& packed = qr_.matrixQR();
  MatrixXd y = MatrixXd::Zero(packed.rows(), 1);
  y.topRows(c.size()) =
      packed.topRows(c.size()).triangularView<Eigen::Upper>().transpose().solve(MatrixXd(c));
  y.applyOnTheLeft(qr_.householderQ());
  return y;
}

VectorXd Qr::inverse_gram(const VectorXd& v) const {
  const auto R = qr_.matrixQR().topRows(v.size()).triangularView<Eigen::Upper>();
  return R.solve(MatrixXd(R.transpose().solve(MatrixXd(v))));
}

MatrixXd Qr::basis() const {
  return qr_.householderQ() * MatrixXd::Identity(qr_.rows(), qr_.cols());
}

template <class Scalar>
PivotedQr<Scalar>::PivotedQr(const Matrix& A) : qr_(A) {}

template <class Scalar>
Index PivotedQr<Scalar>::rank(double tolerance) const {
  const VectorXd sizes = pivots();
  return (sizes.array() > tolerance * qr_.maxPivot()).count();
}

template <class Scalar>
VectorXd PivotedQr<Scalar>::pivots() const {
  return qr_.matrixQR().diagonal().cwiseAbs();
}

template <class Scalar>
typename PivotedQr<Scalar>::Matrix PivotedQr<Scalar>::R() const {
  const Index most = std::min(qr_.rows(), qr_.cols());
  return qr_.matrixQR().topRows(most).template triangularView<Eigen::Upper>();
}

template <class Scalar>
Eigen::VectorXi PivotedQr<Scalar>::order() const {
  return qr_.colsPermutation().indices();
}

template <class Scalar>
typename PivotedQr<Scalar>::Matrix PivotedQr<Scalar>::last_columns_of_Q(Index count) const {
  Matrix last = Matrix::Zero(qr_.rows(), count);
  last.bottomRows(count).setIdentity();
  return qr_.householderQ() * last;
}

template <class Scalar>
typename PivotedQr<Scalar>::Vector PivotedQr<Scalar>::solve(const Vector& b) const {
  return qr_.solve(Matrix(b));
}

template class PivotedQr<double>;
template class PivotedQr<Complex>;

VectorXd shortest_solution(const MatrixXd& A, const VectorXd& b, double tolerance) {
  return shortest(A, b, tolerance);
}

Eigen::VectorXcd shortest_solution(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b,
                                   double tolerance) {
  return shortest(A, b, tolerance);
}

}  // namespace moivre
