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

/// The columns that rows join to `start`, and those that are joined to these, and so on; marked in
/// `is_taken`.
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

StaircaseOrder staircase_order(Pattern pattern, Index columns) {
  StaircaseOrder order;
  order.columns = column_order(pattern, transposed(pattern, columns));
  std::vector<Index>& place = order.place;
  place.resize(at(columns));
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
  order.pattern = std::move(pattern);
  return order;
}

StaircaseOrder staircase_order(const MatrixXd& A) {
  constexpr Index kOrderPays = 32;
  if (A.cols() >= kOrderPays) return staircase_order(pattern_of(A), A.cols());
  StaircaseOrder order;
  order.rows.resize(at(A.rows()));
  order.columns.resize(at(A.cols()));
  std::iota(order.rows.begin(), order.rows.end(), Index{0});
  std::iota(order.columns.begin(), order.columns.end(), Index{0});
  order.place = order.columns;
  order.pattern.assign(order.rows.size(), order.columns);
  order.row_end.assign(order.columns.size(), A.rows());
  order.column_end.assign(order.columns.size(), A.cols());
  return order;
}

StaircaseQr::StaircaseQr(const StaircaseOrder& order)
    : order_(order),
      factors_(RowMajor::Zero(static_cast<Index>(order.rows.size()),
                              static_cast<Index>(order.columns.size()))),
      tau_(VectorXd::Zero(factors_.cols())),
      sum_(static_cast<std::size_t>(factors_.cols())) {}

StaircaseQr::StaircaseQr(const MatrixXd& A, const StaircaseOrder& order) : StaircaseQr(order) {
  factorize([&](Index i, Index k) { return A(i, k); });
}

StaircaseQr StaircaseQr::of_transposed(const MatrixXd& A, const StaircaseOrder& order) {
  StaircaseQr qr(order);
  qr.factorize([&](Index i, Index k) { return A(k, i); });
  return qr;
}

template <class Entry>
void StaircaseQr::factorize(const Entry& entry) {
  for (Index i = 0; i < factors_.rows(); ++i) {
    const Index row = order_.rows[at(i)];
    for (const Index k : order_.pattern[at(row)]) factors_(i, order_.place[at(k)]) = entry(row, k);
  }
  for (Index k = 0; k < factors_.cols(); ++k) eliminate(k);
}

/// One reflection, of the rows that have something in column k. Stairs are narrow: plain loops are
/// the fastest.
void StaircaseQr::eliminate(Index k) {
  const Index below = this->below(k);
  const Index wide = width(k);
  const Index stride = factors_.cols();
  double* const top = &factors_(k, k);
  double rest = 0;
  for (Index i = 1; i <= below; ++i) rest += top[i * stride] * top[i * stride];
  if (!(rest > 0)) return;
  const double head = top[0];
  const double length = std::sqrt(head * head + rest);
  const double leading = head <= 0 ? head - length : -rest / (head + length);
  tau_[k] = 2 * leading * leading / (rest + leading * leading);
  top[0] = length;
  double* const sum = sum_.data();
  for (Index j = 1; j <= wide; ++j) sum[j] = top[j];
  for (Index i = 1; i <= below; ++i) {
    const double* const row = top + i * stride;
    const double share = top[i * stride] /= leading;
    for (Index j = 1; j <= wide; ++j) sum[j] += share * row[j];
  }
  for (Index j = 1; j <= wide; ++j) {
    sum[j] *= tau_[k];
    top[j] -= sum[j];
  }
  for (Index i = 1; i <= below; ++i) {
    double* const row = top + i * stride;
    const double share = row[0];
    for (Index j = 1; j <= wide; ++j) row[j] -= share * sum[j];
  }
}

void StaircaseQr::reflect(Index k, VectorXd& b) const {
  const Index below = this->below(k);
  const Index stride = factors_.cols();
  const double* const column = &factors_(k, k);
  double* const from = &b[k];
  double sum = from[0];
  for (Index i = 1; i <= below; ++i) sum += column[i * stride] * from[i];
  sum *= tau_[k];
  from[0] -= sum;
  for (Index i = 1; i <= below; ++i) from[i] -= sum * column[i * stride];
}

void StaircaseQr::solve_upper(VectorXd& v) const {
  for (Index k = factors_.cols(); k-- > 0;) {
    const double* const row = &factors_(k, k);
    double rest = v[k];
    for (Index j = width(k); j > 0; --j) rest -= row[j] * v[k + j];
    v[k] = rest / row[0];
  }
}

void StaircaseQr::solve_lower(VectorXd& v) const {
  for (Index k = 0; k < factors_.cols(); ++k) {
    const double* const row = &factors_(k, k);
    const double value = v[k] /= row[0];
    for (Index j = 1; j <= width(k); ++j) v[k + j] -= value * row[j];
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

VectorXd StaircaseQr::inverse_gram(const VectorXd& v) const {
  VectorXd x(v.size());
  x(order_.columns) = inverse_squared(v(order_.columns));
  return x;
}

}  // namespace moivre
