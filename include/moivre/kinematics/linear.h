// SPDX-License-Identifier: MIT
// Which x solves A x = b, and in which sense? One factorization, chosen by shape and rank, serves
// many right-hand sides.
//
//   square, regular            lu                x = A^-1 b
//   m > n, rank n              qr                least |A x - b|            (or normal_equations,
//                                                on request)
//   m < n, rank m              minimum_norm      least x^T W x of all solutions
//   rank < min(m, n)           svd               least |A x - b|, of those the least x^T W x
// Symbols: A m x n, b m, x n, W = diag(weights) > 0, empty for the identity. With row units R, |A x
// - b| stands for |R^-1 (A x - b)|.
// Rank is that of A with rows and columns brought to unit length (so that units do not matter),
// counted by column-pivoted QR against kRankTolerance. A method asked for that the rank forbids is
// replaced by svd; `method()` says so.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

namespace moivre {

enum class LinearMethod { lu, normal_equations, qr, minimum_norm, svd };

std::string to_string(LinearMethod method);

/// A pivot this small relative to the largest counts as zero. Poses are known to about 1e-13, and
/// entries of an equilibrated Phi_q are of order 1. So true zeros come out below 1e-11, and a pose
/// nearer than 1e-9 to a singular one counts as singular.
inline constexpr double kRankTolerance = 1e-9;

/// A with its rows, then its columns, divided by their length (by no less than a thousandth of the
/// longest, so that rounding noise in a zero row stays noise).
Eigen::MatrixXd equilibrated(const Eigen::MatrixXd& A);

/// Rank by column-pivoted QR of the equilibrated matrix. With a `tolerance` above kRankTolerance:
/// the number of its singular values above tolerance times the largest, since pivots find only what
/// is zero to rounding.
Eigen::Index numerical_rank(const Eigen::MatrixXd& A, double tolerance = kRankTolerance);

struct LinearOptions {
  std::optional<LinearMethod> method;  ///< none: chosen by shape and rank
  Eigen::VectorXd weights;             ///< diagonal of W, empty: all 1
  /// Units of b and of x, positive, empty: all 1. R^-1 A C is factorized and has the rank, which
  /// suits a matrix whose entries are of very different sizes by their units alone. b, x and W are
  /// as without.
  Eigen::VectorXd row_units{};     ///< diagonal of R
  Eigen::VectorXd column_units{};  ///< diagonal of C
};

class Factorization {
 public:
  /// Throws std::invalid_argument when there are weights or units and they are not positive
  /// numbers, as many as W or R and C have.
  explicit Factorization(const Eigen::MatrixXd& A, const LinearOptions& options = {});

  /// Throws std::invalid_argument when b has not m numbers.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  LinearMethod method() const { return method_; }
  Eigen::Index rank() const { return rank_; }

 private:
  struct Factors;

  Eigen::VectorXd solve_in_units(const Eigen::VectorXd& b) const;

  Eigen::VectorXd row_units_;     ///< m
  Eigen::VectorXd column_units_;  ///< n
  Eigen::MatrixXd A_;             ///< R^-1 A C
  Eigen::VectorXd root_weights_;  ///< (C W C)^(1/2), diagonal
  Eigen::Index rank_ = 0;
  LinearMethod method_ = LinearMethod::lu;
  std::shared_ptr<const Factors> factors_;  ///< none of an empty A; copies share them
};

}  // namespace moivre
