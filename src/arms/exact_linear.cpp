// SPDX-License-Identifier: MIT
// Bareiss' elimination upwards and downwards: rows of integers, every division exact [Bareiss68].
#include "exact_linear.h"

#include "exact_displacement.h"

namespace moivre {
namespace {

constexpr std::size_t kColumns = 8;

/// Rows that have become multiples of unit vectors in the pivots' columns, with one factor in all.
struct Eliminated {
  std::vector<std::vector<Integer>> rows;
  std::vector<std::size_t> pivots;  ///< column of row k's pivot
  Integer factor = 1;               ///< the pivots
};

void eliminate_column(Eliminated& matrix, std::size_t row, std::size_t column) {
  const Integer pivot = matrix.rows[row][column];
  for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
    if (i == row) continue;
    const Integer other = matrix.rows[i][column];
    for (std::size_t j = 0; j < matrix.rows[i].size(); ++j) {
      Integer& entry = matrix.rows[i][j];
      entry = (entry * pivot - other * matrix.rows[row][j]) / matrix.factor;
    }
  }
  matrix.factor = pivot;
  matrix.pivots.push_back(column);
}

/// Pivots are looked for in the first eight columns.
Eliminated eliminated(std::vector<std::vector<Integer>> rows) {
  Eliminated matrix{std::move(rows), {}, 1};
  for (std::size_t column = 0; column < kColumns; ++column) {
    const std::size_t row = matrix.pivots.size();
    if (row == matrix.rows.size()) break;
    std::size_t found = row;
    while (found < matrix.rows.size() && matrix.rows[found][column] == 0) ++found;
    if (found == matrix.rows.size()) continue;
    std::swap(matrix.rows[row], matrix.rows[found]);
    eliminate_column(matrix, row, column);
  }
  return matrix;
}

}  // namespace

std::vector<LinearForm> vanishing_forms(const std::vector<ExactDisplacement>& vectors) {
  std::vector<std::vector<Integer>> rows;
  for (const ExactDisplacement& v : vectors) rows.emplace_back(v.begin(), v.end());
  const Eliminated matrix = eliminated(std::move(rows));
  std::vector<LinearForm> forms;
  for (std::size_t column = 0; column < kColumns; ++column) {
    bool is_pivot = false;
    LinearForm form{};
    for (std::size_t k = 0; k < matrix.pivots.size(); ++k) {
      is_pivot = is_pivot || matrix.pivots[k] == column;
      form[matrix.pivots[k]] = -matrix.rows[k][column];
    }
    if (is_pivot) continue;
    form[column] = matrix.factor;
    forms.push_back(reduced(form));
  }
  return forms;
}

std::vector<LinearForm> coordinate_forms(const std::vector<ExactDisplacement>& vectors) {
  std::vector<std::vector<Integer>> rows;
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    rows.emplace_back(vectors[k].begin(), vectors[k].end());
    rows.back().resize(kColumns + vectors.size());
    rows.back()[kColumns + k] = 1;
  }
  // Behind elimination R V = factor * (unit vectors in the pivots' columns): g = sum a_k v_k has a = R^T g_pivots / factor.
  const Eliminated matrix = eliminated(std::move(rows));
  std::vector<LinearForm> forms(vectors.size());
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    for (std::size_t i = 0; i < matrix.pivots.size(); ++i) {
      forms[k][matrix.pivots[i]] = matrix.rows[i][kColumns + k];
    }
  }
  return forms;
}

Integer value(const LinearForm& form, const ExactDisplacement& g) {
  Integer sum = 0;
  for (std::size_t k = 0; k < kColumns; ++k) sum += form[k] * g[k];
  return sum;
}

}  // namespace moivre
