// SPDX-License-Identifier: MIT
// The bordered system of a path in double-double.
#include "fine_path_system.h"

#include <algorithm>
#include <cmath>

namespace moivre {
namespace {

ComplexDoubleDouble dot(std::span<const ComplexDoubleDouble> a,
                        std::span<const ComplexDoubleDouble> x) {
  ComplexDoubleDouble sum(0.0);
  for (std::size_t i = 0; i < x.size(); ++i) sum += product(a[i], x[i]);
  return sum;
}

}  // namespace

FinePathSystem::FinePathSystem(const Homotopy& homotopy)
    : n_(homotopy.equations()),
      homotopy_(homotopy),
      lu_(n_ + 1),
      patch_(n_ + 1),
      h_(n_),
      ht_(n_),
      dx_(n_ + 1),
      rounded_x_(n_ + 1),
      rounded_dx_(n_ + 1) {}

void FinePathSystem::set_patch(std::span<const ComplexDoubleDouble> x) {
  for (std::size_t i = 0; i <= n_; ++i) patch_[i] = conj(x[i]);
  const ComplexDoubleDouble scale = reciprocal(dot(patch_, x));
  for (ComplexDoubleDouble& ai : patch_) ai = product(scale, ai);
}

void FinePathSystem::bring_to_patch(std::span<ComplexDoubleDouble> x,
                                    std::span<ComplexDoubleDouble> dx) const {
  const ComplexDoubleDouble scale = reciprocal(dot(patch_, x));
  const ComplexDoubleDouble rate = product(scale, dot(patch_, dx));
  for (std::size_t i = 0; i <= n_; ++i) {
    dx[i] = product(scale, dx[i] - product(rate, x[i]));
    x[i] = product(scale, x[i]);
  }
}

bool FinePathSystem::linearize(std::span<const ComplexDoubleDouble> x, const PathTime& t) {
  const std::size_t columns = n_ + 1;
  const auto j = lu_.matrix();
  homotopy_.linearization(x, fine_time(t), h_, j, ht_);
  std::copy(patch_.begin(), patch_.end(), j.begin() + static_cast<std::ptrdiff_t>(n_ * columns));
  norm_ = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    double row = 0;
    for (std::size_t k = 0; k < columns; ++k) row += magnitude1(j[i * columns + k]);
    norm_ = std::max(norm_, row);
  }
  ++work_.linearizations;
  ++work_.factorizations;
  return lu_.factor();
}

double FinePathSystem::correct(std::span<ComplexDoubleDouble> x) {
  for (std::size_t i = 0; i < n_; ++i) dx_[i] = -h_[i];
  dx_[n_] = ComplexDoubleDouble(1.0) - dot(patch_, x);
  lu_.solve(dx_);
  round_into(x, rounded_x_);
  round_into(dx_, rounded_dx_);
  for (std::size_t i = 0; i <= n_; ++i) x[i] += dx_[i];
  return weighted_norm(rounded_dx_, rounded_x_);
}

void FinePathSystem::tangent(Complex dt, std::span<ComplexDoubleDouble> dx) {
  for (std::size_t i = 0; i < n_; ++i) dx[i] = -product(ht_[i], ComplexDoubleDouble(dt));
  dx[n_] = 0.0;
  lu_.solve(dx);
}

double FinePathSystem::condition() {
  std::vector<double> row(n_ + 1);
  for (std::size_t k = 0; k <= n_; ++k) {
    std::fill(dx_.begin(), dx_.end(), ComplexDoubleDouble(0.0));
    dx_[k] = 1.0;
    lu_.solve(dx_);
    for (std::size_t i = 0; i <= n_; ++i) row[i] += magnitude1(dx_[i]);
  }
  return norm_ * *std::max_element(row.begin(), row.end());
}

double FinePathSystem::residual() const {
  double largest = 0;
  for (const ComplexDoubleDouble& hi : h_) largest = std::max(largest, magnitude1(hi));
  return largest;
}

}  // namespace moivre
