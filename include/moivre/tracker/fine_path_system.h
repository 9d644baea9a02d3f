// SPDX-License-Identifier: MIT
// What does the path look like near (x, t), in more digits than double? As tracker/path_system.h,
// without its shortcuts.
//
//   J = [ H_x ; a ],   J dx = [ -H ; 1 - a x ]  Newton correction,   J x' = [ -H_t dt ; 0 ]
//                                               tangent
//
// a: the patch, a row that the tracker moves along with the path. The natural patch x^H would leave
// the scale of x to the predictor. With a predictor of several points, errors of scale would then
// grow from step to step.
// S: a complex scalar (numeric/scalar.h), double-double or one of more digits; e its `epsilon`.
// Everything is evaluated, factored and solved in S, with a fresh J for each correction. Every
// limit is a power of e or a multiple of it: nothing else depends on S.
#pragma once

#include <algorithm>
#include <cmath>

#include "moivre/factorization/dense_lu.h"
#include "moivre/numeric/fused.h"
#include "moivre/tracker/path_system.h"

namespace moivre {

/// t and 1 - t in S; near t = 1 from 1 - t, which has more digits there than double's t.
template <class S>
Time<S> fine_time(const PathTime& t) {
  constexpr double kNear = 0.25;
  const S one(1.0);
  if (std::norm(t.rest) < kNear) return {one - S(t.rest), S(t.rest)};
  return {S(t.t), one - S(t.t)};
}

/// Each coordinate rounded to double.
template <class S>
void round_into(std::span<const S> x, Point& rounded) {
  for (std::size_t i = 0; i < x.size(); ++i) rounded[i] = to_complex(x[i]);
}

/// When a point counts as found by Newton's method.
struct SettlingRules {
  double reach = 0;     ///< |dx_1|_w above which the point is refused
  double aim = 0;       ///< |dx_k|_w that ends it
  double rounding = 0;  ///< |dx_k|_w that passes where rounding stops it
  double share = 0;     ///< |dx_k|_w / |dx_1|_w that ends it as well
};

/// What Newton's method did.
struct Settling {
  bool converged = false;
  double first = 0;   ///< |dx_1|_w
  double second = 0;  ///< |dx_2|_w; 0 where there was none, or rounding made it
  double last = 0;    ///< |dx_k|_w of the last correction
  double drift = 0;   ///< max_i |H_i| before the first one
};

template <class S>
class FinePathSystem {
 public:
  /// Of a point on the way, and of a regular end at t = 1, known beyond double.
  static SettlingRules on_path() { return {kReach, digits(0.5), digits(0.3), 0}; }
  static SettlingRules at_end() { return {kReach, kKnown, digits(0.3), 0}; }
  /// No step is shorter: what is left of t cannot be told from it.
  static constexpr double least_step() { return kKnown; }
  /// |dx| / |x| to which a regular end is known.
  static constexpr double end_accuracy() { return kKnown; }

  explicit FinePathSystem(const Homotopy& homotopy)
      : n_(homotopy.equations()),
        homotopy_(homotopy),
        lu_(n_ + 1),
        patch_(n_ + 1),
        h_(n_),
        ht_(n_),
        dx_(n_ + 1),
        rounded_x_(n_ + 1),
        rounded_dx_(n_ + 1) {}

  std::size_t coordinates() const { return n_ + 1; }

  /// The frame of the path, where the homotopy is framed; it has to stay where it is.
  void set_frame(const PathFrame* frame) { homotopy_.set_frame(frame); }

  /// a <- x^H / |x|^2.
  void set_patch(std::span<const S> x) {
    for (std::size_t i = 0; i <= n_; ++i) patch_[i] = conj(x[i]);
    const S scale = reciprocal(dot(patch_, x));
    for (S& ai : patch_) ai = product(scale, ai);
  }

  /// Point and tangent of the same path where a x = 1.
  void bring_to_patch(std::span<S> x, std::span<S> dx) const {
    const S scale = reciprocal(dot(patch_, x));
    const S rate = product(scale, dot(patch_, dx));
    for (std::size_t i = 0; i <= n_; ++i) {
      dx[i] = product(scale, dx[i] - product(rate, x[i]));
      x[i] = product(scale, x[i]);
    }
  }

  /// Evaluates H, H_x, H_t at (x, t) and factors J. False when J is singular or something is not
  /// finite.
  bool linearize(std::span<const S> x, const PathTime& t) {
    const std::size_t columns = n_ + 1;
    const auto j = lu_.matrix();
    fused([&] { homotopy_.linearization(x, fine_time<S>(t), h_, j, ht_); });
    std::copy(patch_.begin(), patch_.end(), j.begin() + static_cast<std::ptrdiff_t>(n_ * columns));
    norm_ = 0;
    for (std::size_t i = 0; i < columns; ++i) {
      double row = 0;
      for (std::size_t k = 0; k < columns; ++k) row += size1(j[i * columns + k]);
      norm_ = std::max(norm_, row);
    }
    ++work_.linearizations;
    ++work_.factorizations;
    bool is_regular = false;
    fused([&] { is_regular = lu_.factor(); });
    return is_regular;
  }

  /// x <- x + J^{-1} [-H; 1 - a x] with the last linearize(); |dx|_w of tracker/path_system.h.
  double correct(std::span<S> x) {
    for (std::size_t i = 0; i < n_; ++i) dx_[i] = -h_[i];
    dx_[n_] = S(1.0) - dot(patch_, x);
    lu_.solve(dx_);
    round_into<S>(x, rounded_x_);
    round_into<S>(dx_, rounded_dx_);
    for (std::size_t i = 0; i <= n_; ++i) x[i] += dx_[i];
    moved_ = max_norm(rounded_dx_) / max_norm(rounded_x_);
    return weighted_norm(rounded_dx_, rounded_x_);
  }

  /// Newton's method from x at fixed t, x replaced. It is to contract by ten at least, as it does
  /// at no multiple root.
  Settling settle(std::span<S> x, const PathTime& t, const SettlingRules& rules) {
    Settling result;
    double previous = rules.reach;
    for (int k = 0; k < kIterations; ++k) {
      if (!linearize(x, t)) return result;
      if (k == 0) result.drift = residual();
      const double size = correct(x);
      if (!std::isfinite(size)) return result;
      if (k == 0) result.first = size;
      if (k == 1 && size > rules.aim) result.second = size;
      result.last = size;
      if (size > (k == 0 ? 1 : kContraction) * previous) {
        result.converged = k > 0 && size <= rules.rounding && residual() < kRoundingResidual;
        return result;
      }
      if (k > 0 && (size <= rules.aim || size <= rules.share * result.first)) {
        result.converged = true;
        return result;
      }
      previous = size;
    }
    return result;
  }

  /// A point that settled at t = 1 by at_end(): is its last correction what rounding makes of a
  /// condition that S can bear?
  /// Relative to |x|_inf: of a coordinate that is 0, rounding makes much more relative to its own
  /// floor.
  bool is_regular_end() {
    const double bearable = condition();
    return bearable <= kHopelessCondition && moved_ <= std::max(kKnown, kNoise * bearable);
  }

  /// dx <- J^{-1} [-H_t dt; 0] with the last linearize().
  void tangent(Complex dt, std::span<S> dx) {
    for (std::size_t i = 0; i < n_; ++i) dx[i] = -product(ht_[i], S(dt));
    dx[n_] = S(0.0);
    lu_.solve(dx);
  }

  /// |J|_inf |J^{-1}|_inf of the last linearize(), rows as they are.
  double condition() {
    std::vector<double> row(n_ + 1);
    for (std::size_t k = 0; k <= n_; ++k) {
      std::fill(dx_.begin(), dx_.end(), S(0.0));
      dx_[k] = S(1.0);
      lu_.solve(dx_);
      for (std::size_t i = 0; i <= n_; ++i) row[i] += size1(dx_[i]);
    }
    return norm_ * *std::max_element(row.begin(), row.end());
  }

  /// max_i |H_i| of the last linearize().
  double residual() const {
    double largest = 0;
    for (const S& hi : h_) largest = std::max(largest, size1(hi));
    return largest;
  }

  const WorkCount& work() const noexcept { return work_; }

 private:
  static constexpr double kEpsilon = Scalar<S>::epsilon;
  static constexpr double kReach = 1e-2;
  // Newton's method has to contract by this factor, which no multiple root allows (a double root:
  // 1/2).
  static constexpr double kContraction = 0.1;
  static constexpr int kIterations = 12;
  // Equations have coefficients near 1 and |x| is near 1: a residual below this is made of rounding
  // errors.
  static constexpr double kRoundingResidual = 2e4 * kEpsilon;
  // At an end corrections are also to be no larger than rounding makes them: so many times the
  // condition.
  static constexpr double kNoise = 20 * kEpsilon;
  // A point is known where corrections fall below this.
  static constexpr double kKnown = 2e5 * kEpsilon;
  // From here on J, evaluated in S, says nothing about the end.
  static constexpr double kHopelessCondition = 1 / kKnown;

  /// That share of the digits.
  static double digits(double share) { return std::pow(kEpsilon, share); }
  static double size1(const S& a) { return magnitude1(to_complex(a)); }
  static S dot(std::span<const S> a, std::span<const S> x) {
    S sum(0.0);
    for (std::size_t i = 0; i < x.size(); ++i) sum += product(a[i], x[i]);
    return sum;
  }

  std::size_t n_;
  HomotopyEvaluator<S> homotopy_;
  DenseLu<S> lu_;
  std::vector<S> patch_;  // a
  std::vector<S> h_;
  std::vector<S> ht_;
  std::vector<S> dx_;
  Point rounded_x_;
  Point rounded_dx_;
  double norm_ = 0;   // |J|_inf
  double moved_ = 0;  // |dx|_inf / |x|_inf of the last correction
  WorkCount work_;
};

extern template class FinePathSystem<ComplexDoubleDouble>;

}  // namespace moivre
