// SPDX-License-Identifier: MIT
// Which x comes nearest to A x = b, and how many columns of A are independent? Householder's QR
// factorizations.
//
//   Qr                  A = Q R                  full rank is taken for granted
//   PivotedQr           A P = Q R                the next column is always the longest that is left
//   shortest_solution   A P = Q [R 0; 0 0] Z     least |x| among those of least |A x - b|
// Symbols: A m x n, b m, Q m x m, R min(m, n) x n, P a permutation, Z n x n. The one place that
// instantiates them.
// Edges: a pivot counts as zero if it is at most `tolerance` times the largest; a matrix of zeros
// has rank 0.
// Not supported: matrices without rows or columns.
// Source: [GolubVanLoan13], ch. 5.
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <complex>

namespace moivre {

/// Of a real A, m >= n.
class Qr {
 public:
  Qr() = default;
  explicit Qr(const Eigen::MatrixXd& A);

  /// Least |A x - b|.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// The shortest y with A^T y = c.
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& c) const;
  /// (A^T A)^-1 v
  Eigen::VectorXd inverse_gram(const Eigen::VectorXd& v) const;
  /// The first n columns of Q: an orthonormal basis of the span of A.
  Eigen::MatrixXd basis() const;

 private:
  Eigen::HouseholderQR<Eigen::MatrixXd> qr_;
};

/// Scalar: double or std::complex<double>.
template <class Scalar>
class PivotedQr {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  explicit PivotedQr(const Matrix& A);

  Eigen::Index rank(double tolerance) const;
  /// |R_kk|, which do not grow but for rounding.
  Eigen::VectorXd pivots() const;
  Matrix R() const;
  /// The columns of A in the order in which they were taken.
  Eigen::VectorXi order() const;
  /// The last columns of Q: orthogonal to all columns of A where these have rank m - count.
  Matrix last_columns_of_Q(Eigen::Index count) const;
  /// Least |A x - b|, with zeros where pivots vanish to rounding.
  Vector solve(const Vector& b) const;

 private:
  Eigen::ColPivHouseholderQR<Matrix> qr_;
};

/// To rounding: min(m, n) times the distance from 1 to the next double.
inline constexpr double kToRounding = 0;

Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                  double tolerance = kToRounding);
Eigen::VectorXcd shortest_solution(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b,
                                   double tolerance = kToRounding);

}  // namespace moivre
