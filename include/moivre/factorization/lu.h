// SPDX-License-Identifier: MIT
// Solve J x = b for a small dense complex matrix, many times, without allocating; how far is J from
// singular?
//
//   R J = P L U,   R = diag(r_i) with r_i = 2^-e, 2^e near max_j |J_ij| w_j: rows brought to one
//                  size
//   before pivoting [Skeel79], so that a polynomial multiplied by a constant changes nothing. w:
//   the sizes of the unknowns, so that a row that matters to a small unknown is not taken for a
//   large one.
//
// J: n x n, row-major, row i = equation i. Singular to working precision: is_singular(), and solves
// give infinities or NaN that the caller sees. Own code because Eigen's PartialPivLU takes 2.6
// times as long at n = 9.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "moivre/numeric/complex.h"

namespace moivre {

class Lu {
 public:
  explicit Lu(std::size_t n);

  std::size_t size() const noexcept { return n_; }

  /// The matrix to be filled by the caller before factor(); overwritten by it.
  std::span<Complex> matrix() noexcept { return a_; }

  /// Factors what stands in matrix(). weights: w, n positive numbers; none: all 1.
  /// False when a pivot is zero or not finite.
  bool factor(std::span<const double> weights = {}) noexcept;

  /// b <- J^{-1} b.
  void solve(std::span<Complex> b) noexcept;

  /// columns <- J^{-1}, n x n, one column after another: as n solves give it, faster.
  void invert(std::span<Complex> columns);

  /// b <- J^{-H} b, the conjugate transpose's solve (for the condition estimate).
  void solve_adjoint(std::span<Complex> b) noexcept;

  /// Estimate of the infinity-norm condition number of R J, the row-scaled matrix [Higham88]:
  /// a lower bound, nearly always within a factor of 3. Infinity when singular.
  double condition() noexcept;

  /// Estimate of |J|_inf |J^{-1}|_inf, rows as they were given. A row that vanishes makes this
  /// large, and leaves condition() as it was. Infinity when singular.
  double unscaled_condition() noexcept;

  bool is_singular() const noexcept { return singular_; }

 private:
  void find_zeros() noexcept;
  double norm_of_inverse(bool row_scaled) noexcept;

  std::size_t n_;
  std::vector<Complex> a_;           // n x n, L below the diagonal (unit), U on and above
  std::vector<std::size_t> begin_;   // of what is not zero in a row of L
  std::vector<std::size_t> end_;     // of what is not zero in a row of U
  std::vector<double> row_scale_;    // r_i
  std::vector<std::size_t> pivot_;   // row exchanged with k at step k
  std::vector<Complex> reciprocal_;  // 1/U_kk
  std::vector<Complex> work_;
  std::vector<Complex> rows_;        // of the inverse; empty until it is asked for
  std::vector<std::size_t> source_;  // of row k after all exchanges; empty until then
  double norm_ = 0;                  // |J|_inf
  double scaled_norm_ = 0;           // |R J|_inf
  bool singular_ = true;
};

}  // namespace moivre
