// SPDX-License-Identifier: MIT
// Solve J x = b in any complex scalar: elimination with partial pivoting, rows compared by their
// own sizes.
//
//   P J = L U,  the pivot of column k is the row with the largest |a_ik| / max_j |J_ij|
//
// J: n x n, row-major. S needs -, product(S, S), reciprocal(S) and magnitude1(S), an ordered real.
// For scalars beyond double; factorization/lu.h is the one for inner loops in double. Not
// supported: condition estimates.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace moivre {

template <class S>
class DenseLu {
 public:
  explicit DenseLu(std::size_t n) : n_(n), a_(n * n), row_(n) {}

  std::size_t size() const noexcept { return n_; }

  /// To be filled by the caller before factor(); overwritten by it.
  std::span<S> matrix() { return a_; }

  /// False when a pivot is zero or not a number.
  bool factor() {
    scales_.assign(n_, Magnitude(0));
    for (std::size_t i = 0; i < n_; ++i) {
      row_[i] = i;
      for (std::size_t j = 0; j < n_; ++j) {
        const Magnitude size = magnitude1(a_[i * n_ + j]);
        if (size > scales_[i]) scales_[i] = size;
      }
    }
    reciprocal_.clear();
    for (std::size_t k = 0; k < n_; ++k) {
      if (!bring_pivot(k)) return false;
      reciprocal_.push_back(reciprocal(a_[row_[k] * n_ + k]));
      for (std::size_t i = k + 1; i < n_; ++i) eliminate(k, row_[k] * n_, row_[i] * n_);
    }
    return true;
  }

  /// b <- J^{-1} b.
  void solve(std::span<S> b) {
    y_.resize(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      S sum = b[row_[i]];
      for (std::size_t j = 0; j < i; ++j) sum = sum - product(a_[row_[i] * n_ + j], y_[j]);
      y_[i] = sum;
    }
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t j = i + 1; j < n_; ++j) {
        y_[i] = y_[i] - product(a_[row_[i] * n_ + j], y_[j]);
      }
      y_[i] = product(y_[i], reciprocal_[i]);
    }
    for (std::size_t i = 0; i < n_; ++i) b[i] = y_[i];
  }

 private:
  using Magnitude = std::decay_t<decltype(magnitude1(std::declval<const S&>()))>;

  bool bring_pivot(std::size_t k) {
    std::size_t best = k;
    Magnitude largest(0);
    for (std::size_t i = k; i < n_; ++i) {
      const Magnitude size = magnitude1(a_[row_[i] * n_ + k]);
      if (!(size > Magnitude(0))) continue;
      const Magnitude relative = size / scales_[row_[i]];
      if (!(relative > largest)) continue;
      largest = relative;
      best = i;
    }
    std::swap(row_[k], row_[best]);
    return largest > Magnitude(0);
  }

  /// Row `target` less its multiple of row `source`, both offsets into a_; the multiple stays in L.
  void eliminate(std::size_t k, std::size_t source, std::size_t target) {
    if (!(magnitude1(a_[target + k]) > Magnitude(0))) return;
    const S factor = product(a_[target + k], reciprocal_[k]);
    a_[target + k] = factor;
    for (std::size_t j = k + 1; j < n_; ++j) {
      a_[target + j] = a_[target + j] - product(factor, a_[source + j]);
    }
  }

  std::size_t n_;
  std::vector<S> a_;               // L below the diagonal (unit), U on and above, rows by row_
  std::vector<std::size_t> row_;   // row of J that stands in place k
  std::vector<S> reciprocal_;      // 1/U_kk
  std::vector<Magnitude> scales_;  // max_j |J_ij|
  std::vector<S> y_;
};

}  // namespace moivre
