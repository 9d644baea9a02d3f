// SPDX-License-Identifier: MIT
// Columns by breadth first search, rows by their first column, and reflections within the stairs.
#include "staircase_qr.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

/// The columns that rows join to `start`, and those that are joined to these, and so on; marked in `is_taken`.
std::vector<Index> joined_columns(const Pattern& rows, const Pattern& columns, Index start,
                                  std::vector<bool>& is_taken) {
  std::vector<Index> order{start};
  is_taken[at(start)] = true;
  const auto has_fewer_rows = [&](Index a, Index b) {
    return columns[at(a)].size() < columns[at(b)].size();
  };
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto first_new = static_cast<std::ptrdiff_t>(order.size());
    for (const Index row : columns[at(order[k])]) {
      for (const Index column : rows[at(row)]) {
        if (is_taken[at(column)]) continue;
        is_taken[at(column)] = true;
        order.insert(
            std::upper_bound(order.begin() + first_new, order.end(), column, has_fewer_rows),
            column);
      }
    }
  }
  return order;
}

/// From one end to the other: from what is farthest from any column.
std::vector<Index> column_order(const Pattern& rows, const Pattern& columns) {
  std::vector<Index> order;
  std::vector<bool> is_taken(columns.size(), false);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (is_taken[k]) continue;
    std::vector<bool> tried = is_taken;
    const Index end = joined_columns(rows, columns, static_cast<Index>(k), tried).back();
    const std::vector<Index> piece = joined_columns(rows, columns, end, is_taken);
    order.insert(order.end(), piece.begin(), piece.end());
  }
  return order;
}

}  // namespace

Pattern pattern_of(const MatrixXd& A) {
  Pattern pattern(at(A.rows()));
  for (Index k = 0; k < A.cols(); ++k) {
    for (Index i = 0; i < A.rows(); ++i) {
      if (A(i, k) != 0) pattern[at(i)].push_back(k);
    }
  }
  return pattern;
}

Pattern transposed(const Pattern& pattern, Index columns) {
  Pattern result(at(columns));
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    for (const Index k : pattern[i]) result[at(k)].push_back(static_cast<Index>(i));
  }
  return result;
}

StaircaseOrder staircase_order(const Pattern& pattern, Index columns) {
  StaircaseOrder order;
  order.columns = column_order(pattern, transposed(pattern, columns));
  std::vector<Index> place(at(columns));
  for (std::size_t k = 0; k < order.columns.size(); ++k) {
    place[at(order.columns[k])] = static_cast<Index>(k);
  }
  std::vector<std::pair<Index, Index>> reach;  // first and last column of each row
  for (const auto& row : pattern) {
    reach.emplace_back(columns, -1);
    for (const Index k : row) {
      reach.back().first = std::min(reach.back().first, place[at(k)]);
      reach.back().second = std::max(reach.back().second, place[at(k)]);
    }
  }
  order.rows.resize(pattern.size());
  std::iota(order.rows.begin(), order.rows.end(), Index{0});
  std::stable_sort(order.rows.begin(), order.rows.end(),
                   [&](Index a, Index b) { return reach[at(a)] < reach[at(b)]; });
  Index row = 0;
  Index end = 0;
  for (Index k = 0; k < columns; ++k) {
    while (row < static_cast<Index>(pattern.size()) && reach[at(order.rows[at(row)])].first <= k) {
      end = std::max(end, reach[at(order.rows[at(row)])].second + 1);
      ++row;
    }
    order.row_end.push_back(std::max(row, k + 1));
    order.column_end.push_back(std::max(end, k + 1));
  }
  return order;
}

StaircaseQr::StaircaseQr(const MatrixXd& A, const StaircaseOrder& order)
    : order_(order), factors_(A.rows(), A.cols()), tau_(VectorXd::Zero(A.cols())) {
  for (Index i = 0; i < A.rows(); ++i) {
    for (Index k = 0; k < A.cols(); ++k) {
      factors_(i, k) = A(order.rows[at(i)], order.columns[at(k)]);
    }
  }
  for (Index k = 0; k < A.cols(); ++k) eliminate(k);
}

/// One reflection, of the rows that have something in column k.
void StaircaseQr::eliminate(Index k) {
  const Index below = order_.row_end[at(k)] - k - 1;
  auto column = factors_.col(k).segment(k + 1, below);
  const double rest = column.squaredNorm();
  if (!(rest > 0)) return;
  const double head = factors_(k, k);
  const double length = std::sqrt(head * head + rest);
  const double leading = head <= 0 ? head - length : -rest / (head + length);
  tau_[k] = 2 * leading * leading / (rest + leading * leading);
  column /= leading;
  factors_(k, k) = length;
  if (width(k) == 0) return;
  auto top = factors_.row(k).segment(k + 1, width(k));
  auto block = factors_.block(k + 1, k + 1, below, width(k));
  Eigen::RowVectorXd sum = top;
  for (Index i = 0; i < below; ++i) sum += column[i] * block.row(i);
  sum *= tau_[k];
  top -= sum;
  for (Index i = 0; i < below; ++i) block.row(i) -= column[i] * sum;
}

void StaircaseQr::reflect(Index k, VectorXd& b) const {
  const Index below = order_.row_end[at(k)] - k - 1;
  const auto column = factors_.col(k).segment(k + 1, below);
  const double sum = tau_[k] * (b[k] + column.dot(b.segment(k + 1, below)));
  b[k] -= sum;
  b.segment(k + 1, below) -= sum * column;
}

void StaircaseQr::solve_upper(VectorXd& v) const {
  for (Index k = factors_.cols(); k-- > 0;) {
    v[k] -= factors_.row(k).segment(k + 1, width(k)).dot(v.segment(k + 1, width(k)));
    v[k] /= factors_(k, k);
  }
}

void StaircaseQr::solve_lower(VectorXd& v) const {
  for (Index k = 0; k < factors_.cols(); ++k) {
    v[k] /= factors_(k, k);
    v.segment(k + 1, width(k)) -= v[k] * factors_.row(k).segment(k + 1, width(k)).transpose();
  }
}

double StaircaseQr::smallest_diagonal() const { return factors_.diagonal().cwiseAbs().minCoeff(); }

bool StaircaseQr::is_regular() const {
  return factors_.diagonal().allFinite() && smallest_diagonal() > 0;
}

VectorXd StaircaseQr::solve(const VectorXd& b) const {
  VectorXd v = b(order_.rows);
  for (Index k = 0; k < factors_.cols(); ++k) reflect(k, v);
  v.conservativeResize(factors_.cols());
  solve_upper(v);
  VectorXd x(v.size());
  x(order_.columns) = v;
  return x;
}

VectorXd StaircaseQr::solve_transposed(const VectorXd& c) const {
  VectorXd head = c(order_.columns);
  solve_lower(head);
  VectorXd v = VectorXd::Zero(factors_.rows());
  v.head(head.size()) = head;
  for (Index k = factors_.cols(); k-- > 0;) reflect(k, v);
  VectorXd y(v.size());
  y(order_.rows) = v;
  return y;
}

VectorXd StaircaseQr::left_null_vector() const {
  VectorXd v = VectorXd::Unit(factors_.rows(), factors_.rows() - 1);
  for (Index k = factors_.cols(); k-- > 0;) reflect(k, v);
  VectorXd y(v.size());
  y(order_.rows) = v;
  return y;
}

VectorXd StaircaseQr::squared(const VectorXd& v) const {
  VectorXd image(v.size());
  for (Index k = 0; k < v.size(); ++k) {
    const Index count = width(k) + 1;
    image[k] = factors_.row(k).segment(k, count).dot(v.segment(k, count));
  }
  VectorXd result = VectorXd::Zero(v.size());
  for (Index k = 0; k < v.size(); ++k) {
    const Index count = width(k) + 1;
    result.segment(k, count) += image[k] * factors_.row(k).segment(k, count).transpose();
  }
  return result;
}

VectorXd StaircaseQr::inverse_squared(VectorXd v) const {
  solve_lower(v);
  solve_upper(v);
  return v;
}

}  // namespace moivre
