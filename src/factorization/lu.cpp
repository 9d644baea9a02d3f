// SPDX-License-Identifier: MIT
// LU with row scaling and partial pivoting, and Higham's condition estimate on its factors.
#include "moivre/factorization/lu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "moivre/numeric/unit_scale.h"

namespace moivre {

Lu::Lu(std::size_t n)
    : n_(n),
      a_(n * n),
      begin_(n),
      end_(n),
      row_scale_(n, 1.0),
      pivot_(n),
      reciprocal_(n),
      work_(n) {}

namespace {

/// row -= factor * pivot_row over [begin, end).
void eliminate_row(Complex* row, const Complex* pivot_row, Complex factor, std::size_t begin,
                   std::size_t end) {
  const double lr = factor.real();
  const double li = factor.imag();
  auto* r = reinterpret_cast<double*>(row);
  const auto* u = reinterpret_cast<const double*>(pivot_row);
  for (std::size_t j = begin; j < end; ++j) {
    r[2 * j] -= lr * u[2 * j] - li * u[2 * j + 1];
    r[2 * j + 1] -= lr * u[2 * j + 1] + li * u[2 * j];
  }
}

/// Smaller matrices have few zeros, and to look for them takes as long as they cost.
constexpr std::size_t kSparseSize = 16;
/// Of an elimination: a column that is looked up takes so many times as long as the next one.
constexpr std::size_t kLookedUp = 2;
constexpr std::size_t kMostLookedUp = 128;

/// The columns behind k in which a pivot row is not zero, where they are so few that passing over
/// the others pays.
class FewColumns {
 public:
  FewColumns(const Complex* pivot_row, std::size_t k, std::size_t n) noexcept {
    if (n < kSparseSize) return;
    const std::size_t most = std::min(kMostLookedUp, (n - k) / kLookedUp);
    for (std::size_t j = k + 1; j < n; ++j) {
      if (pivot_row[j] == 0.0) continue;
      if (count_ == most) return;
      columns_[count_++] = static_cast<std::uint32_t>(j);
    }
    are_few_ = true;
  }

  explicit operator bool() const noexcept { return are_few_; }

  void eliminate(Complex* row, const Complex* pivot_row, Complex factor) const noexcept {
    for (std::size_t c = 0; c < count_; ++c) {
      const std::size_t j = columns_[c];
      row[j] -= product(factor, pivot_row[j]);
    }
  }

 private:
  std::array<std::uint32_t, kMostLookedUp> columns_;
  std::size_t count_ = 0;
  bool are_few_ = false;
};

}  // namespace

bool Lu::factor(std::span<const double> weights) noexcept {
  singular_ = false;
  norm_ = scaled_norm_ = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    Complex* row = &a_[i * n_];
    double largest = 0;
    double sum = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      const double size = magnitude1(row[j]);
      largest = std::max(largest, weights.empty() ? size : size * weights[j]);
      sum += size;
    }
    const double scale = power_of_two_scale(largest);
    row_scale_[i] = scale;
    for (std::size_t j = 0; j < n_; ++j) row[j] *= scale;
    norm_ = std::max(norm_, sum);
    scaled_norm_ = std::max(scaled_norm_, sum * scale);
  }
  for (std::size_t k = 0; k < n_; ++k) {
    std::size_t best = k;
    double largest = std::norm(a_[k * n_ + k]);
    for (std::size_t i = k + 1; i < n_; ++i) {
      const double size = std::norm(a_[i * n_ + k]);
      if (size > largest) {
        largest = size;
        best = i;
      }
    }
    pivot_[k] = best;
    if (best != k) {
      std::swap_ranges(&a_[k * n_], &a_[k * n_] + n_, &a_[best * n_]);
    }
    if (!(largest > 0) || !std::isfinite(largest)) {
      singular_ = true;
      return false;
    }
    reciprocal_[k] = reciprocal(a_[k * n_ + k]);
    const Complex* const pivot_row = &a_[k * n_];
    const FewColumns few(pivot_row, k, n_);
    for (std::size_t i = k + 1; i < n_; ++i) {
      if (a_[i * n_ + k] == 0.0) continue;
      const Complex l = product(a_[i * n_ + k], reciprocal_[k]);
      a_[i * n_ + k] = l;
      if (few) {
        few.eliminate(&a_[i * n_], pivot_row, l);
      } else {
        eliminate_row(&a_[i * n_], pivot_row, l, k + 1, n_);
      }
    }
  }
  find_zeros();
  return true;
}

/// At the outer ends of rows, which solves pass over: what they add is nothing.
void Lu::find_zeros() noexcept {
  for (std::size_t i = 0; i < n_; ++i) {
    const Complex* const row = &a_[i * n_];
    begin_[i] = 0;
    while (begin_[i] < i && row[begin_[i]] == 0.0) ++begin_[i];
    end_[i] = n_;
    while (end_[i] > i + 1 && row[end_[i] - 1] == 0.0) --end_[i];
  }
}

void Lu::solve(std::span<Complex> b) noexcept {
  for (std::size_t i = 0; i < n_; ++i) b[i] *= row_scale_[i];
  for (std::size_t k = 0; k < n_; ++k) std::swap(b[k], b[pivot_[k]]);
  // Columns of the inverse begin with zeros, which come to nothing.
  std::size_t first = 0;
  while (first < n_ && b[first] == Complex(0)) ++first;
  for (std::size_t i = first + 1; i < n_; ++i) {
    Complex sum = b[i];
    for (std::size_t j = std::max(first, begin_[i]); j < i; ++j) {
      sum -= product(a_[i * n_ + j], b[j]);
    }
    b[i] = sum;
  }
  for (std::size_t i = n_; i-- > 0;) {
    Complex sum = b[i];
    for (std::size_t j = i + 1; j < end_[i]; ++j) sum -= product(a_[i * n_ + j], b[j]);
    b[i] = product(sum, reciprocal_[i]);
  }
}

// All columns together, row by row of the inverse.
void Lu::invert(std::span<Complex> columns) {
  rows_.assign(n_ * n_, Complex(0));
  // Row k of P R has its one number where row k came from.
  source_.resize(n_);
  std::iota(source_.begin(), source_.end(), std::size_t{0});
  for (std::size_t k = 0; k < n_; ++k) std::swap(source_[k], source_[pivot_[k]]);
  for (std::size_t i = 0; i < n_; ++i) {
    Complex* const row = &rows_[i * n_];
    row[source_[i]] = row_scale_[source_[i]];
    for (std::size_t j = begin_[i]; j < i; ++j) {
      const Complex l = a_[i * n_ + j];
      if (l != 0.0) eliminate_row(row, &rows_[j * n_], l, 0, n_);
    }
  }
  for (std::size_t i = n_; i-- > 0;) {
    Complex* const row = &rows_[i * n_];
    for (std::size_t j = i + 1; j < end_[i]; ++j) {
      const Complex u = a_[i * n_ + j];
      if (u != 0.0) eliminate_row(row, &rows_[j * n_], u, 0, n_);
    }
    for (std::size_t k = 0; k < n_; ++k)
      columns[k * n_ + i] = row[k] = product(row[k], reciprocal_[i]);
  }
}

void Lu::solve_adjoint(std::span<Complex> b) noexcept {
  for (std::size_t i = 0; i < n_; ++i) {
    Complex sum = b[i];
    for (std::size_t j = 0; j < i; ++j) sum -= conjugate_product(a_[j * n_ + i], b[j]);
    b[i] = conjugate_product(reciprocal_[i], sum);
  }
  for (std::size_t i = n_; i-- > 0;) {
    Complex sum = b[i];
    for (std::size_t j = i + 1; j < n_; ++j) sum -= conjugate_product(a_[j * n_ + i], b[j]);
    b[i] = sum;
  }
  for (std::size_t k = n_; k-- > 0;) std::swap(b[k], b[pivot_[k]]);
  for (std::size_t i = 0; i < n_; ++i) b[i] *= row_scale_[i];
}

// |A^{-1}|_inf = |A^{-H}|_1 by Higham's estimator of the 1-norm, which solves with A^{-H} and
// A^{-1}.
// A is J or R J; the solves are those of J, and R is divided out on the way.
double Lu::norm_of_inverse(bool row_scaled) noexcept {
  constexpr int kMaximumIterations = 5;
  auto& x = work_;
  const auto divide_by_row_scale = [&] {
    for (std::size_t i = 0; row_scaled && i < n_; ++i) x[i] /= row_scale_[i];
  };
  std::fill(x.begin(), x.end(), Complex(1 / static_cast<double>(n_)));
  double estimate = 0;
  std::size_t last = n_;
  for (int iteration = 0; iteration < kMaximumIterations; ++iteration) {
    solve_adjoint(x);
    divide_by_row_scale();
    double norm = 0;
    for (const Complex& xi : x) norm += modulus(xi);
    if (!std::isfinite(norm)) return std::numeric_limits<double>::infinity();
    if (iteration > 0 && norm <= estimate) break;
    estimate = norm;
    for (Complex& xi : x) {
      const double size = modulus(xi);
      xi = size > 0 ? xi / size : Complex(1);
    }
    divide_by_row_scale();
    solve(x);
    std::size_t largest = 0;
    for (std::size_t i = 1; i < n_; ++i) {
      if (std::norm(x[i]) > std::norm(x[largest])) largest = i;
    }
    if (largest == last) break;
    last = largest;
    std::fill(x.begin(), x.end(), Complex(0));
    x[largest] = 1;
  }
  return estimate;
}

double Lu::condition() noexcept {
  if (singular_) return std::numeric_limits<double>::infinity();
  return n_ == 0 ? 1 : scaled_norm_ * norm_of_inverse(true);
}

double Lu::unscaled_condition() noexcept {
  if (singular_) return std::numeric_limits<double>::infinity();
  return n_ == 0 ? 1 : norm_ * norm_of_inverse(false);
}

}  // namespace moivre
