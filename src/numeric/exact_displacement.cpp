// SPDX-License-Identifier: MIT
// Bareiss' elimination upwards and downwards: rows of integers, every division exact [Bareiss68].
#include "moivre/numeric/exact_displacement.h"

#include <algorithm>
#include <cmath>

namespace moivre {
namespace {

constexpr std::size_t kColumns = ExactDisplacement::size();

/// [V | 1] with V's rows combined until they are multiples of unit vectors in the pivots' columns,
/// with one factor in all.
class Eliminated {
 public:
  Eliminated(const std::vector<ExactDisplacement>& vectors, double length) {
    for (std::size_t k = 0; k < vectors.size(); ++k) {
      std::vector<Integer>& row = rows_.emplace_back(kColumns + vectors.size());
      for (std::size_t j = 0; j < kColumns; ++j) row[j] = vectors[k][j];
      row[kColumns + k] = 1;
    }
    while (pivots_.size() < rows_.size() && bring_largest(std::log2(length))) eliminate();
  }

  bool is_pivot(std::size_t column) const {
    return std::find(pivots_.begin(), pivots_.end(), column) != pivots_.end();
  }

  /// It vanishes on the vectors; `column`: one without pivot.
  ExactDisplacement vanishing(std::size_t column) const {
    ExactDisplacement form;
    for (std::size_t k = 0; k < pivots_.size(); ++k) form[pivots_[k]] = -rows_[k][column];
    form[column] = factor_;
    return reduced(form);
  }

  /// R V = factor (unit vectors in the pivots' columns), R in the last columns: g = sum a_k v_k has
  /// a = R^T g_pivots / factor.
  const Integer& factor() const { return factor_; }
  ExactDisplacement coordinate(std::size_t vector) const {
    ExactDisplacement form;
    for (std::size_t k = 0; k < pivots_.size(); ++k) form[pivots_[k]] = rows_[k][kColumns + vector];
    return form;
  }

 private:
  /// The next pivot, by bits, into the first row that has none. False where nothing is left.
  bool bring_largest(double bits_of_length) {
    double largest = 0;
    std::size_t from = 0;
    std::size_t column = kColumns;
    for (std::size_t i = pivots_.size(); i < rows_.size(); ++i) {
      for (std::size_t j = 0; j < kColumns; ++j) {
        if (rows_[i][j] == 0 || is_pivot(j)) continue;
        const double bits =
            static_cast<double>(bit_length(rows_[i][j])) - (j < 4 ? 0 : bits_of_length);
        if (column != kColumns && bits <= largest) continue;
        largest = bits;
        from = i;
        column = j;
      }
    }
    if (column == kColumns) return false;
    std::swap(rows_[pivots_.size()], rows_[from]);
    pivots_.push_back(column);
    return true;
  }

  /// The last pivot's column from the other rows.
  void eliminate() {
    const std::vector<Integer> row = rows_[pivots_.size() - 1];
    const Integer pivot = row[pivots_.back()];
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (i + 1 == pivots_.size()) continue;
      const Integer other = rows_[i][pivots_.back()];
      for (std::size_t j = 0; j < row.size(); ++j) {
        rows_[i][j] = (rows_[i][j] * pivot - other * row[j]) / factor_;
      }
    }
    factor_ = pivot;
  }

  std::vector<std::vector<Integer>> rows_;
  std::vector<std::size_t> pivots_;  ///< column of row k's pivot
  Integer factor_ = 1;               ///< the pivots
};

}  // namespace

ExactDisplacement reduced(ExactDisplacement g) {
  Integer common = 0;
  for (std::size_t k = 0; k < g.size(); ++k) common = gcd(common, g[k]);
  return common > 1 ? mapped(g, [&](const Integer& part) { return Integer(part / common); }) : g;
}

Integer common_denominator(const std::vector<DualQuaternion<Rational>>& all) {
  Integer common = 1;
  for (const auto& g : all) {
    for (std::size_t k = 0; k < g.size(); ++k) common = lcm(common, denominator(g[k]));
  }
  return common;
}

ExactDisplacement whole(const DualQuaternion<Rational>& g, const Integer& common) {
  return mapped(g, [&](const Rational& part) {
    return Integer(numerator(part) * (common / denominator(part)));
  });
}

Integer largest_part(const ExactDisplacement& g) {
  Integer largest = 0;
  for (std::size_t k = 0; k < g.size(); ++k) largest = std::max<Integer>(largest, abs(g[k]));
  return largest;
}

DualQuaternion<double> rounded(const ExactDisplacement& g) {
  const Integer largest = largest_part(g);
  return mapped(g, [&](const Integer& part) { return to_double(ratio(part, largest)); });
}

std::vector<ExactDisplacement> vanishing_forms(const std::vector<ExactDisplacement>& vectors,
                                               double length) {
  const Eliminated matrix(vectors, length);
  std::vector<ExactDisplacement> forms;
  for (std::size_t column = 0; column < kColumns; ++column) {
    if (!matrix.is_pivot(column)) forms.push_back(matrix.vanishing(column));
  }
  return forms;
}

CoordinateForms coordinate_forms(const std::vector<ExactDisplacement>& vectors, double length) {
  const Eliminated matrix(vectors, length);
  CoordinateForms coordinates{{}, matrix.factor()};
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    coordinates.forms.push_back(matrix.coordinate(k));
  }
  return coordinates;
}

}  // namespace moivre
