// SPDX-License-Identifier: MIT
// The bordered system of a path in double-double.
#include "moivre/tracker/fine_path_system.h"

#include <algorithm>
#include <cmath>

#include "moivre/numeric/fused.h"

namespace moivre {
namespace {

// Newton's method has to contract by this factor, which no multiple root allows (a double root: 1/2).
constexpr double kContraction = 0.1;
constexpr int kIterations = 8;
// Equations have coefficients near 1 and |x| is near 1: a residual below this is made of rounding errors.
constexpr double kRoundingResidual = 1e-27;
// At an end corrections are also to be no larger than rounding makes them: so many times the condition.
constexpr double kNoise = 1e-30;
// From here on J, evaluated in double-double, says nothing about the end.
constexpr double kHopelessCondition = 1e26;

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
  fused([&] { homotopy_.linearization(x, fine_time(t), h_, j, ht_); });
  std::copy(patch_.begin(), patch_.end(), j.begin() + static_cast<std::ptrdiff_t>(n_ * columns));
  norm_ = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    double row = 0;
    for (std::size_t k = 0; k < columns; ++k) row += magnitude1(j[i * columns + k]);
    norm_ = std::max(norm_, row);
  }
  ++work_.linearizations;
  ++work_.factorizations;
  bool is_regular = false;
  fused([&] { is_regular = lu_.factor(); });
  return is_regular;
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

Settling FinePathSystem::settle(std::span<ComplexDoubleDouble> x, const PathTime& t,
                                const SettlingRules& rules) {
  Settling result;
  double previous = rules.reach;
  for (int k = 0; k < kIterations; ++k) {
    if (!linearize(x, t)) return result;
    if (k == 0) result.drift = residual();
    const double size = correct(x);
    if (!std::isfinite(size)) return result;
    if (k == 0) result.first = size;
    result.last = size;
    if (size > (k == 0 ? 1 : kContraction) * previous) {
      result.converged = k > 0 && size <= rules.rounding && residual() < kRoundingResidual;
      return result;
    }
    if (size <= rules.aim) {
      result.converged = true;
      return result;
    }
    previous = size;
  }
  return result;
}

bool FinePathSystem::is_regular_end(const Settling& settling) {
  const double bearable = condition();
  return bearable <= kHopelessCondition &&
         settling.last <= std::max(kSettledAtEnd.aim, kNoise * bearable);
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
