// SPDX-License-Identifier: MIT
// The bordered system of a path: evaluation, factorization, Newton's method on the natural patch.
#include "moivre/tracker/path_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "moivre/numeric/fused.h"

namespace moivre {
namespace {

// Equations have coefficients near 1 and |x| near 1: a residual below this is made of rounding
// errors.
constexpr double kRoundingResidual = 1e-12;

}  // namespace

double weighted_norm(std::span<const Complex> v, std::span<const Complex> x) {
  double largest_squared = 0;
  for (const Complex& xi : x) largest_squared = std::max(largest_squared, std::norm(xi));
  const double floor_squared = kRelativeFloor * kRelativeFloor * largest_squared;
  double result = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double ratio = std::norm(v[i]) / std::max(std::norm(x[i]), floor_squared);
    if (std::isnan(ratio)) return std::numeric_limits<double>::quiet_NaN();
    result = std::max(result, ratio);
  }
  return std::sqrt(result);
}

WorkCount& WorkCount::operator+=(const WorkCount& other) {
  values += other.values;
  fine_values += other.fine_values;
  linearizations += other.linearizations;
  factorizations += other.factorizations;
  return *this;
}

PathSystem::PathSystem(const Homotopy& homotopy)
    : definition_(homotopy),
      n_(homotopy.equations()),
      homotopy_(homotopy),
      lu_(n_ + 1),
      h_(n_),
      ht_(n_),
      dx_(n_ + 1),
      weights_(n_ + 1) {}

void PathSystem::set_frame(const PathFrame* frame) noexcept {
  frame_ = frame;
  homotopy_.set_frame(frame);
  if (fine_) fine_->homotopy.set_frame(frame);
}

bool PathSystem::linearize(std::span<const Complex> x, const PathTime& t) noexcept {
  const std::span<Complex> j = lu_.matrix();
  homotopy_.linearization(x, t, h_, j, ht_);
  double largest = 0;
  for (std::size_t k = 0; k <= n_; ++k) {
    j[n_ * (n_ + 1) + k] = std::conj(x[k]);
    weights_[k] = magnitude1(x[k]);
    largest = std::max(largest, weights_[k]);
  }
  for (double& w : weights_) w = std::max(w, kRelativeFloor * largest);
  ++work_.linearizations;
  ++work_.factorizations;
  return lu_.factor(weights_);
}

void PathSystem::tangent(Complex dt, std::span<Complex> dx) noexcept {
  for (std::size_t i = 0; i < n_; ++i) dx[i] = -product(ht_[i], dt);
  dx[n_] = 0;
  lu_.solve(dx);
}

bool PathSystem::newton_step(std::span<Complex> x, double& size) noexcept {
  for (std::size_t i = 0; i < n_; ++i) dx_[i] = -h_[i];
  dx_[n_] = 0;
  lu_.solve(dx_);
  size = weighted_norm(dx_, x);
  if (!std::isfinite(size)) return false;
  for (std::size_t i = 0; i <= n_; ++i) x[i] += dx_[i];
  return true;
}

void PathSystem::evaluate_fine(std::span<const Complex> x, const PathTime& t) noexcept {
  if (!fine_) {
    fine_ = std::make_unique<Fine>(definition_);
    fine_->homotopy.set_frame(frame_);
  }
  std::copy(x.begin(), x.end(), fine_->x.begin());
  // t is taken from 1 - t near t = 1, where that has more digits than double's t.
  const ComplexDoubleDouble one(1.0);
  const bool near_end = std::norm(t.rest) < 0.25;
  const ComplexDoubleDouble rest = near_end ? ComplexDoubleDouble(t.rest) : one - t.t;
  const ComplexDoubleDouble time = near_end ? one - rest : ComplexDoubleDouble(t.t);
  fused([&] { fine_->homotopy.value(fine_->x, {time, rest}, fine_->value); });
  for (std::size_t i = 0; i < n_; ++i) h_[i] = to_complex(fine_->value[i]);
  ++work_.fine_values;
}

Correction PathSystem::correct(std::span<Complex> x, const PathTime& t,
                               const CorrectorOptions& options, bool fresh) noexcept {
  Correction result;
  bool renewed = fresh;
  bool fine = options.fine;
  double previous = 0;
  for (int k = 0; k < options.maximum_iterations; ++k) {
    if (fresh) {
      if (!linearize(x, t)) return result;
    } else if (!fine) {
      homotopy_.value(x, t, h_);
      ++work_.values;
    }
    if (fine) evaluate_fine(x, t);
    fresh = options.renews;
    if (k == 0) result.residual = residual();
    if (!newton_step(x, result.last)) return result;
    if (k == 0) {
      result.first = result.last;
      if (result.first > options.largest_correction) return result;
    } else if (result.last > options.largest_contraction * previous &&
               result.last > options.tolerance) {
      const bool rounding = residual() < kRoundingResidual;
      if (fine || (renewed && !rounding)) break;
      fine = rounding;
      renewed = fresh = true;
      // The next correction repairs what rounding did to this one, and may be as large.
      if (fine) result.last = std::numeric_limits<double>::infinity();
    }
    // Of quadratic convergence the next correction is known before it is made.
    const bool is_quadratic = options.renews && k > 0 && std::isfinite(previous);
    const double ratio = is_quadratic ? result.last / previous : 1;
    if (result.last * ratio * ratio <= options.tolerance) {
      result.converged = true;
      return result;
    }
    previous = result.last;
  }
  result.converged = result.last <= options.stagnation;
  return result;
}

const FineEnds& PathSystem::fine_ends() {
  if (!fine_ends_) {
    FineEnds ends;
    for (std::size_t k = 0; k < definition_.terms(); ++k) {
      ends.f.push_back(to_complex_double_double(definition_.f(k)));
      ends.g.push_back(to_complex_double_double(definition_.g(k)));
    }
    fine_ends_ = std::make_unique<const FineEnds>(std::move(ends));
  }
  return *fine_ends_;
}

double PathSystem::residual() const noexcept {
  double largest = 0;
  for (const Complex& hi : h_) largest = std::max(largest, modulus(hi));
  return largest;
}

}  // namespace moivre
