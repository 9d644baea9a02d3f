// SPDX-License-Identifier: MIT
// Krawczyk's operator in double: all that depends on the radii is a vector, so that trying others
// costs little.
#include "double_stage.h"

#include <algorithm>
#include <limits>

#include "moivre/numeric/fused.h"

namespace moivre {
namespace {

// Newton's method: a root of a tracker takes two corrections. What has not settled after so many is
// for more digits.
constexpr int kMostCorrections = 5;
// A correction of this share of the point is rounding.
constexpr double kSettled = 0x1p-53;
// The size of an unknown is at least this share of the largest one: less is no scale for a
// correction.
constexpr double kLeastWeight = 0x1p-40;

/// Radii to begin with: shares of the error and of the point's coordinates, each taken for no
/// smaller than a share of the largest.
struct Start {
  double of_error, of_point, least_weight;
  int attempts;
};
// The first one serves nearly all. The second: coordinates much smaller than others bend F. The
// third: J is nearly singular.
constexpr Start kStarts[] = {{512, 0x1p-44, 0x1p-10, 2}, {512, 0x1p-44, 0, 3}, {2, 0x1p-52, 0, 8}};
// A radius must be positive where the point is 0 and F vanishes there exactly.
constexpr double kLeastRadius = 0x1p-900;
// The image shrinks by |I - Y J| each time that it is taken for the ball.
constexpr int kTightenings = 2;
// Beyond this quotient of kappa and rho no wider ball will hold its image; but a radius of the
// first attempt may be far too small, that of a coordinate that vanishes.
constexpr double kHopeless = 0x1p30;
constexpr double kHuge = 0x1p900;

// Sums of so many terms are raised once (upward.h): 2^8 operations.
constexpr std::size_t kLargestDimension = 250;

/// Roundings of a sum of n complex products, each product's sqrt(5) u with it, twice as many to be
/// safe.
double sum_rounding(std::size_t n) { return 2 * kUnitRoundoff * (static_cast<double>(n) + 8); }

/// sum <- sum + y a + g b.
void add_columns(const double* __restrict y, double a, const double* __restrict g, double b,
                 std::vector<double>& sum) {
  double* __restrict s = sum.data();
  const std::size_t n = sum.size();
  for (std::size_t j = 0; j < n; ++j) s[j] += y[j] * a + g[j] * b;
}

}  // namespace

DoubleStage::DoubleStage(const CertifyProgram& program)
    : program_(program),
      n_(program.dimension()),
      rounding_(sum_rounding(n_)),
      lu_(n_),
      m_(n_),
      f_(n_),
      step_(n_),
      e_(n_),
      weights_(n_),
      fine_x_(program.tape.variables),
      fine_registers_(program.tape.register_count()),
      fine_values_(n_),
      x_(program.tape.variables),
      registers_(program.tape.register_count()),
      values_(n_),
      jacobian_(program.tape.jacobian.size()),
      y_(n_ * n_),
      g_(n_ * n_),
      size_y_(n_ * n_),
      size_g_(n_ * n_),
      fixed_(n_),
      load_(n_),
      rho_(n_),
      kappa_(n_),
      image_(n_) {}

bool DoubleStage::prove(std::span<const Complex> x, std::span<const Enclosure> given,
                        double accuracy, Certificate& result) {
  if (n_ > kLargestDimension) return false;
  take(given);
  if (!approach(x, accuracy)) return false;
  invert();
  if (!find_radii()) return false;
  result.midpoint.assign(m_.begin(), m_.end());
  result.finer.clear();
  result.bits = kDoubleBits;
  result.sizes.assign(rho_, kappa_);
  return result.sizes.are_apart();
}

/// Given numbers are variables that no radius of an unknown moves: F(m) is a ball then, and its
/// size counts like an error of F.
void DoubleStage::take(std::span<const Enclosure> given) {
  for (std::size_t k = 0; k < given.size(); ++k) {
    double radius = given[k].error;
    for (const Complex& part : given[k].finer) radius += size_bound(part);
    if (radius > 0) radius = raised(radius);
    fine_x_[n_ + k] = FineBall(ComplexDoubleDouble(given[k].middle), radius);
    x_[n_ + k] = Ball(given[k].middle, radius);
  }
}

/// Newton's method from x, until its correction is rounding. False where it leaves the
/// neighbourhood or J is singular.
bool DoubleStage::approach(std::span<const Complex> x, double accuracy) {
  std::copy(x.begin(), x.end(), m_.begin());
  double size = 1;
  for (const Complex& xi : x) size = std::max(size, modulus(xi));
  for (int k = 0;; ++k) {
    residual();
    if (!linearize()) return false;
    const double share = correction();
    if (share <= kSettled || k == kMostCorrections) return true;
    double moved = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      m_[j] -= step_[j];
      moved = std::max(moved, modulus(m_[j] - x[j]));
    }
    // Twice: a first step may be too long.
    if (moved > 2 * accuracy * size) return false;
  }
}

/// f_ and e_: F(m) and its bound, from double-double.
void DoubleStage::residual() {
  for (std::size_t j = 0; j < n_; ++j) fine_x_[j] = FineBall(ComplexDoubleDouble(m_[j]), 0);
  fused([&] {
    evaluate<FineBall, CoefficientBall<ComplexDoubleDouble>>(
        program_.tape, program_.fine_coefficients, fine_x_, fine_registers_, fine_values_);
  });
  for (std::size_t i = 0; i < n_; ++i) {
    f_[i] = to_complex(fine_values_[i].middle);
    e_[i] = raised(fine_values_[i].radius + rounding_ * size_bound(f_[i]));
  }
}

/// The LU of J(m). False where it is singular.
bool DoubleStage::linearize() {
  largest_ = max_norm(m_);
  if (!std::isfinite(largest_)) return false;
  for (std::size_t j = 0; j < n_; ++j) {
    weights_[j] = std::max(modulus(m_[j]), kLeastWeight * largest_);
    if (!(weights_[j] > 0)) weights_[j] = 1;
  }
  jacobian_of_ball(false);
  const std::span<Complex> a = lu_.matrix();
  std::fill(a.begin(), a.end(), Complex(0));
  for (std::size_t k = 0; k < jacobian_.size(); ++k) {
    const Tape::Entry& entry = program_.tape.jacobian[k];
    a[entry.row * n_ + entry.column] = jacobian_[k].middle();
  }
  return lu_.factor(weights_);
}

/// step_ <- J^{-1} f; its share of the point.
double DoubleStage::correction() {
  std::copy(f_.begin(), f_.end(), step_.begin());
  lu_.solve(step_);
  double share = 0;
  for (std::size_t j = 0; j < n_; ++j) {
    const double s = modulus(step_[j]) / weights_[j];
    share = s <= share ? share : s;  // NaN is kept
  }
  return share;
}

/// Y near J(m)^{-1}, G = I - Y J, and their sizes; c and the part of kappa that is free of rho.
void DoubleStage::invert() {
  lu_.invert(y_);
  std::fill(g_.begin(), g_.end(), Complex(0));
  for (std::size_t j = 0; j < n_; ++j) g_[j * n_ + j] = 1;
  for (std::size_t s = 0; s < jacobian_.size(); ++s) {
    const Tape::Entry& entry = program_.tape.jacobian[s];
    const Complex a = jacobian_[s].middle();
    for (std::size_t j = 0; j < n_; ++j) {
      g_[entry.column * n_ + j] -= product(y_[entry.row * n_ + j], a);
    }
  }
  for (std::size_t k = 0; k < n_ * n_; ++k) {
    size_y_[k] = size_bound(y_[k]);
    size_g_[k] = size_bound(g_[k]);
  }
  std::fill(step_.begin(), step_.end(),
            Complex(0));  // now c, in the order that its bound was made for
  std::fill(fixed_.begin(), fixed_.end(), 0.0);
  for (std::size_t k = 0; k < n_; ++k) {
    for (std::size_t j = 0; j < n_; ++j) {
      step_[j] += product(y_[k * n_ + j], f_[k]);
      fixed_[j] += size_y_[k * n_ + j] * e_[k];
    }
  }
  for (std::size_t j = 0; j < n_; ++j) fixed_[j] = raised(raised(fixed_[j]) + size_bound(step_[j]));
}

bool DoubleStage::find_radii() {
  for (const Start& start : kStarts) {
    for (std::size_t j = 0; j < n_; ++j) {
      const double size = std::max(modulus(m_[j]), start.least_weight * largest_);
      rho_[j] = start.of_error * fixed_[j] + start.of_point * size + kLeastRadius;
    }
    if (!inflate(start.attempts)) continue;
    for (int k = 0; k < kTightenings; ++k) tighten();
    return true;
  }
  return false;
}

/// True where kappa < rho in every coordinate, after radii were doubled as often as that helped.
bool DoubleStage::inflate(int attempts) {
  for (int attempt = 0; attempt < attempts; ++attempt) {
    image();
    bool inside = true;
    for (std::size_t j = 0; j < n_; ++j) {
      if (kappa_[j] < rho_[j]) continue;
      if (!(kappa_[j] < (attempt == 0 ? kHuge : kHopeless * rho_[j]))) return false;
      inside = false;
    }
    if (inside) return true;
    for (std::size_t j = 0; j < n_; ++j) {
      if (!(kappa_[j] < rho_[j])) rho_[j] = 2 * kappa_[j];
    }
  }
  return false;
}

/// Discs of J over the ball of radii rho around m, or at m alone. The middles are the same: the
/// radii do not enter them.
void DoubleStage::jacobian_of_ball(bool with_radii) {
  for (std::size_t j = 0; j < n_; ++j) x_[j] = Ball(m_[j], with_radii ? rho_[j] : 0);
  evaluate<Ball, CoefficientBall<Complex>>(program_.tape, program_.coefficients, x_, registers_,
                                           values_, jacobian_);
}

/// kappa of rho.
void DoubleStage::image() {
  jacobian_of_ball(true);
  apply(rho_);
  std::swap(kappa_, image_);
}

/// The root lies within kappa of m: so it lies within the image of that, too. J(B) holds there as
/// well.
void DoubleStage::tighten() {
  apply(kappa_);
  for (std::size_t j = 0; j < n_; ++j) kappa_[j] = std::min(kappa_[j], image_[j]);
}

/// image_ <- |Y F(m)| + |I - Y J(B)| reach.
void DoubleStage::apply(std::span<const double> reach) {
  std::fill(load_.begin(), load_.end(), 0.0);
  for (std::size_t s = 0; s < jacobian_.size(); ++s) {
    const Tape::Entry& entry = program_.tape.jacobian[s];
    const Ball& a = jacobian_[s];
    load_[entry.row] += (a.radius + rounding_ * size_bound(a.re, a.im)) * reach[entry.column];
  }
  for (double& l : load_) l = raised(l);
  for (std::size_t j = 0; j < n_; ++j) image_[j] = rounding_ * reach[j];
  for (std::size_t k = 0; k < n_; ++k) {
    add_columns(&size_y_[k * n_], load_[k], &size_g_[k * n_], reach[k], image_);
  }
  for (std::size_t j = 0; j < n_; ++j) image_[j] = raised(raised(image_[j]) + fixed_[j]);
}

}  // namespace moivre
