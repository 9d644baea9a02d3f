// SPDX-License-Identifier: MIT
// Elimination by rows that have the right side behind them.
#include "six_equations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "moivre/numeric/fused.h"

namespace moivre {
namespace {

constexpr std::size_t kSize = 6;

template <std::size_t k>
using Number = std::integral_constant<std::size_t, k>;

/// Numbers that the compiler knows, so that loops behind them have no counters.
template <class F>
void for_each_of_six(const F& take) {
  [&]<std::size_t... k>(std::index_sequence<k...>) { (take(Number<k>()), ...); }
  (std::make_index_sequence<kSize>());
}

/// With the right side behind, and a 0.
using Row = std::array<double, kSize + 2>;
using Rows = std::array<Row, kSize>;

/// Whether the largest pivot below is not 0; then the rows below it have 0 under it.
template <std::size_t k>
bool eliminate(Rows& rows, SixSolved& solved) {
  std::size_t pivot = k;
  double size = std::abs(rows[k][k]);
  for (std::size_t i = k + 1; i < kSize; ++i) {
    const double other = std::abs(rows[i][k]);
    if (other > size) size = other, pivot = i;
  }
  if (pivot != k) std::swap(rows[pivot], rows[k]);
  solved.least = k == 0 ? size : std::min(solved.least, size);
  solved.largest = std::max(solved.largest, size);
  if (!(size > 0)) {
    solved.least = 0;
    return false;
  }
  const double share = 1 / rows[k][k];
  constexpr std::size_t kBegin = (k + 1) / 2 * 2;  // processors take two at once
  for (std::size_t i = k + 1; i < kSize; ++i) {
    const double factor = rows[i][k] * share;
    for (std::size_t j = kBegin; j < kSize + 2; ++j) rows[i][j] -= factor * rows[k][j];
  }
  rows[k][k] = share;
  return true;
}

/// Of symmetric rows the lower half.
template <std::size_t k>
void eliminate_below(SixFactors& factors) {
  double* const L = factors.L.data();
  const double pivot = L[kSize * k + k];
  factors.least = k == 0 ? pivot : std::min(factors.least, pivot);
  factors.largest = std::max(factors.largest, pivot);
  factors.share[k] = 1 / pivot;
  std::array<double, kSize> below{};
  for (std::size_t i = k + 1; i < kSize; ++i) {
    below[i] = L[kSize * k + i];
    L[kSize * k + i] *= factors.share[k];
  }
  for (std::size_t j = k + 1; j < kSize; ++j) {
    for (std::size_t i = j; i < kSize; ++i) L[kSize * j + i] -= L[kSize * k + j] * below[i];
  }
}

}  // namespace

SixFactors factors_of(const Matrix6d& A) {
  SixFactors factors;
  factors.L = A;
  for_each_of_six([&]<std::size_t k>(Number<k>) { eliminate_below<k>(factors); });
  return factors;
}

Velocity6<double> solution_of(const SixFactors& factors, const Velocity6<double>& b) {
  const double* const L = factors.L.data();
  Velocity6<double> solution = b;
  double* const x = solution.data();
  for_each_of_six([&]<std::size_t k>(Number<k>) {
    for (std::size_t i = k + 1; i < kSize; ++i) x[i] -= L[kSize * k + i] * x[k];
  });
  for_each_of_six([&]<std::size_t k>(Number<k>) {
    constexpr std::size_t kRow = kSize - 1 - k;
    x[kRow] *= factors.share[kRow];
    for (std::size_t i = kRow + 1; i < kSize; ++i) x[kRow] -= L[kSize * kRow + i] * x[i];
  });
  return solution;
}

SixSolved solve_six(const Matrix6d& A, const Velocity6<double>& b) {
  SixSolved solved;
  fused([&] {
    Rows rows;
    for (std::size_t i = 0; i < kSize; ++i) {
      for (std::size_t k = 0; k < kSize; ++k) rows[i][k] = A.data()[kSize * k + i];
      rows[i][kSize] = b.data()[i];
      rows[i][kSize + 1] = 0;
    }
    bool goes_on = true;
    for_each_of_six(
        [&]<std::size_t k>(Number<k>) { goes_on = goes_on && eliminate<k>(rows, solved); });
    if (!goes_on) return;
    for_each_of_six([&]<std::size_t k>(Number<k>) {
      constexpr std::size_t kRow = kSize - 1 - k;
      double rest = rows[kRow][kSize];
      for (std::size_t j = kRow + 1; j < kSize; ++j) rest -= rows[kRow][j] * solved.x.data()[j];
      solved.x.data()[kRow] = rest * rows[kRow][kRow];
    });
  });
  return solved;
}

SixSolved solve_symmetric_six(const Matrix6d& A, const Velocity6<double>& b) {
  const SixFactors factors = factors_of(A);
  return {solution_of(factors, b), factors.least, factors.largest};
}

Matrix6d gram_of(const Matrix6d& A) {
  Matrix6d gram;
  for (Eigen::Index k = 0; k < gram.cols(); ++k) {
    for (Eigen::Index i = 0; i <= k; ++i) gram(k, i) = gram(i, k) = A.col(i).dot(A.col(k));
  }
  return gram;
}

}  // namespace moivre
