// SPDX-License-Identifier: MIT
// How is a QR factorization of a mechanism's Jacobian made at the cost of what is not zero in it?
//
// A constraint reads the coordinates of a few bodies. With columns in the order in which the
// constraints join them (Cuthill and McKee), and rows by their first column, what is not zero lies
// in a staircase, and Householder's reflections stay in it: n b^2 operations instead of n^3 for
// stairs b wide.
// Symbols: A m x n, m >= n; P_r A P_c = Q R; pattern: the columns of each row that may not be zero.
// Edges: R of a matrix without full rank has zeros, or rounding, on its diagonal; nothing is
// pivoted, `is_regular` tells exact zeros and what is no number only.
// Source: [GolubVanLoan13], ch. 5 and 11.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace moivre {

using Pattern = std::vector<std::vector<Eigen::Index>>;

/// Of what is not zero in A.
Pattern pattern_of(const Eigen::MatrixXd& A);
/// The rows of each column.
Pattern transposed(const Pattern& pattern, Eigen::Index columns);

struct StaircaseOrder {
  Pattern pattern;  ///< that it was made for
  std::vector<Eigen::Index> rows;
  std::vector<Eigen::Index> columns;
  std::vector<Eigen::Index> place;  ///< of each column among `columns`
  std::vector<Eigen::Index>
      row_end;  ///< rows before this have something in the first k + 1 columns
  std::vector<Eigen::Index> column_end;  ///< columns before this, in the rows that column k changes
};

StaircaseOrder staircase_order(Pattern pattern, Eigen::Index columns);
/// For this matrix alone. A small one stays as it is, one stair: to find an order takes longer than
/// to do without.
StaircaseOrder staircase_order(const Eigen::MatrixXd& A);

class StaircaseQr {
 public:
  /// Nothing of A lies outside of the pattern that `order` was made for; `order` must outlive it.
  StaircaseQr(const Eigen::MatrixXd& A, const StaircaseOrder& order);
  /// Of A^T; `order` is for its pattern.
  static StaircaseQr of_transposed(const Eigen::MatrixXd& A, const StaircaseOrder& order);

  bool is_regular() const;
  /// Of R, modulus.
  double smallest_diagonal() const;
  /// Least |A x - b|.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// The shortest y with A^T y = c.
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& c) const;
  /// m = n + 1: the unit vector with A^T y = 0.
  Eigen::VectorXd left_null_vector() const;

  /// (A^T A)^-1 v
  Eigen::VectorXd inverse_gram(const Eigen::VectorXd& v) const;

  /// In the order of R: R^T R v, and the inverse of that.
  Eigen::VectorXd squared(const Eigen::VectorXd& v) const;
  Eigen::VectorXd inverse_squared(Eigen::VectorXd v) const;

 private:
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  explicit StaircaseQr(const StaircaseOrder& order);
  template <class Entry>
  void factorize(const Entry& entry);
  void eliminate(Eigen::Index k);
  void reflect(Eigen::Index k, Eigen::VectorXd& b) const;
  Eigen::Index width(Eigen::Index k) const {
    return order_.column_end[static_cast<std::size_t>(k)] - k - 1;
  }
  Eigen::Index below(Eigen::Index k) const {
    return order_.row_end[static_cast<std::size_t>(k)] - k - 1;
  }
  void solve_upper(Eigen::VectorXd& v) const;
  void solve_lower(Eigen::VectorXd& v) const;

  const StaircaseOrder& order_;
  RowMajor factors_;  ///< R, and below it the reflections, each without its leading 1
  Eigen::VectorXd tau_;
  std::vector<double> sum_;  ///< of rows, while one column is eliminated
};

}  // namespace moivre
