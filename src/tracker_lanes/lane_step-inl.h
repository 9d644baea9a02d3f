// SPDX-License-Identifier: MIT
// What is one step of all lanes? Predict, correct twice, tangent. One evaluation with Jacobian, one
// factorization, one value.
//
//   x_p  from the nodes                               H, H_x, H_t at x_p; J = [H_x; a] factored
//   J dx_1 = [-H; 1 - a x_p],  J x' = [-H_t dt; 0]    x_1 = x_p + dx_1
//   J dx_2 = [-H(x_1); 0]                             x_2 = x_1 + dx_2     (simplified Newton)
//   J dx'  = [-(H_x(x_1) x' + H_t dt); 0]             x' <- x' + dx'       (the tangent at x_1,
//          refined)
//
// A step of length 0 is a Newton correction of the point at hand. |.|_w as in
// tracker/path_system.h, at x_p.
// An equation of degree d at a point of norm 1 in N coordinates may be as small as N^(-d/2), and
// smaller where the path goes far: a row that double could not square is brought to about 1, in its
// lane alone, by a power of two. Such rows are expected of high degrees; else a pivot tells them.
#if defined(MOIVRE_LANE_STEP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MOIVRE_LANE_STEP_INL_H_
#undef MOIVRE_LANE_STEP_INL_H_
#else
#define MOIVRE_LANE_STEP_INL_H_
#endif

#include <cmath>
#include <vector>

#include "lane_homotopy-inl.h"
#include "lane_path-inl.h"
#include "moivre/numeric/unit_scale.h"
#include "moivre/tracker/path_system.h"

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

/// log2 of a size whose square, and a little less, is a normal double.
inline constexpr int kLeastSquaredLog2 = -480;

template <class R>
class LaneStep {
 public:
  using Number = typename LaneScalar<R>::Number;

  LaneStep(const Homotopy& homotopy, const typename LaneHomotopy<R>::Program& program)
      : n_(program.values.size()),
        homotopy_(homotopy, program),
        lu_(n_ + 1),
        h_(n_ + 1),
        ht_(n_ + 1),
        weights_(n_ + 1),
        scales_(n_),
        corrected(n_ + 1),
        tangent(n_ + 1) {
    const double size_log2 = -0.5 * std::log2(static_cast<double>(n_ + 1));
    for (const std::uint64_t degree : degrees(homotopy.support())) {
      if (static_cast<double>(degree) * size_log2 < kLeastSquaredLog2) expects_small_rows_ = true;
    }
  }

  /// Of the path in `lane`, where the homotopy is framed.
  void set_frame(std::size_t lane, const FramePointer& frame) { homotopy_.set_frame(lane, frame); }

  /// Takes every lane of `path` a step h ahead, to the times given. Results are the members below;
  /// `path` is not changed.
  void take(const LanePath<R>& path, const LaneReals& h, const LaneTime<R>& time) {
    LaneVector<R>& x = corrected;
    path.predict(h.value(), x);
    homotopy_.move(time);
    factor_at(x, path, time, expects_small_rows_ ? every_lane() : no_lane());
    const Mask lost = lanes_with_small_pivots();
    const bool has_small_rows = expects_small_rows_ || !is_nowhere(lost);
    if (has_small_rows && !expects_small_rows_) factor_at(x, path, time, lost);
    find_weights(x);
    lu_.solve_appended(h_, tangent);
    store_real(weighted(h_), first.at);
    add(h_, x);
    homotopy_.expand(x, tangent, time, h_, ht_);
    if (has_small_rows) scale_sides();
    negate(h_);
    negate(ht_);
    lu_.solve(h_, ht_);
    store_real(weighted(h_), second.at);
    add(h_, x);
    add(ht_, tangent);
  }

  /// Puts x, its scale its own, and its tangent in the place of a lane's results.
  void replace(std::size_t lane, const LaneVector<R>& patch, std::span<const Number> x,
               std::span<const Number> dx) {
    Number ax(0.0);
    Number adx(0.0);
    for (std::size_t i = 0; i <= n_; ++i) {
      ax += product(patch.get(i, lane), x[i]);
      adx += product(patch.get(i, lane), dx[i]);
    }
    const Number scale = moivre::reciprocal(ax);
    for (std::size_t i = 0; i <= n_; ++i) {
      const Number xi = product(scale, x[i]);
      corrected.set(i, lane, xi);
      tangent.set(i, lane, product(scale, dx[i] - product(xi, adx)));
    }
  }

 private:
  static Mask every_lane() { return zeros() == zeros(); }
  static Mask no_lane() { return zeros() < zeros(); }

  /// J at x, factored, and its right-hand sides; small rows of these lanes are scaled.
  void factor_at(const LaneVector<R>& x, const LanePath<R>& path, const LaneTime<R>& time,
                 Mask scaled) {
    homotopy_.linearize(x, time, h_, lu_, ht_);
    measure_residual();
    if (!is_nowhere(scaled)) scale_rows(scaled);
    append_patch(path, time);
    lu_.factor();
  }

  Mask lanes_with_small_pivots() const {
    const double least = std::ldexp(1.0, 2 * kLeastSquaredLog2);
    return lu_.least_squared_pivot() < broadcast(least);
  }

  void scale_rows(Mask scaled) {
    const double least = std::ldexp(1.0, kLeastSquaredLog2);
    const V other = broadcast(1.0);
    for (std::size_t i = 0; i < n_; ++i) {
      V largest = zeros();
      for (std::size_t j = 0; j <= n_; ++j) {
        const LaneComplex<R> a = load(lu_.at(i, j));
        largest = larger(largest, larger(hn::Abs(rounded(a.re)), hn::Abs(rounded(a.im))));
      }
      store_real(select(scaled, largest, other), scales_[i].at);
      for (double& lane : scales_[i].at) lane = lane < least ? power_of_two_scale(lane) : 1;
      for (std::size_t j = 0; j <= n_; ++j) {
        store(scales_[i].value() * load(lu_.at(i, j)), lu_.at(i, j));
      }
    }
    scale_sides();
  }
  void scale_sides() {
    for (std::size_t i = 0; i < n_; ++i) {
      store(scales_[i].value() * load(h_[i]), h_[i]);
      store(scales_[i].value() * load(ht_[i]), ht_[i]);
    }
  }

  void append_patch(const LanePath<R>& path, const LaneTime<R>& time) {
    const LaneComplex<R> dt = time.dt();
    for (std::size_t i = 0; i < n_; ++i) {
      store(-load(h_[i]), lu_.at(i, n_ + 1));
      store(-(dt * load(ht_[i])), lu_.at(i, n_ + 2));
    }
    for (std::size_t j = 0; j <= n_; ++j) store(load(path.patch()[j]), lu_.at(n_, j));
    store(path.distance(corrected), lu_.at(n_, n_ + 1));
    store(zero<R>(), lu_.at(n_, n_ + 2));
  }

  void measure_residual() {
    V largest = zeros();
    for (std::size_t i = 0; i < n_; ++i) {
      largest = larger(largest, squared_magnitude(load(h_[i])));
    }
    store_real(square_root(largest), residual.at);
  }

  // 1 / w_i^2.
  void find_weights(const LaneVector<R>& x) {
    V largest = zeros();
    for (std::size_t i = 0; i <= n_; ++i) {
      largest = larger(largest, squared_magnitude(load(x[i])));
    }
    const V floor = largest * broadcast(kRelativeFloor * kRelativeFloor);
    for (std::size_t i = 0; i <= n_; ++i) {
      const V squared = larger(squared_magnitude(load(x[i])), floor);
      store_real(broadcast(1.0) / squared, weights_[i].at[0]);
    }
  }

  // A sum tells a NaN that a maximum might drop.
  V weighted(const LaneVector<R>& dx) const {
    V largest = zeros();
    V sum = zeros();
    for (std::size_t i = 0; i <= n_; ++i) {
      const V squared = squared_magnitude(load(dx[i])) * load_real(weights_[i].at[0]);
      largest = larger(largest, squared);
      sum = sum + squared;
    }
    const Mask finite = sum <= broadcast(std::numeric_limits<double>::max());
    return select(finite, square_root(largest), sum);
  }

  void add(const LaneVector<R>& dx, LaneVector<R>& x) const {
    for (std::size_t i = 0; i <= n_; ++i) store(load(x[i]) + load(dx[i]), x[i]);
  }
  void negate(LaneVector<R>& b) const {
    for (std::size_t i = 0; i < n_; ++i) store(-load(b[i]), b[i]);
    store(zero<R>(), b[n_]);
  }

  std::size_t n_;
  LaneHomotopy<R> homotopy_;
  LaneLu<R> lu_;
  LaneVector<R> h_;
  LaneVector<R> ht_;
  LaneVector<V> weights_;
  bool expects_small_rows_ = false;
  std::vector<LaneReals> scales_;  // of the rows

 public:
  LaneVector<R> corrected;  ///< x_2
  LaneVector<R> tangent;    ///< x'
  LaneReals first;          ///< |dx_1|_w
  LaneReals second;         ///< |dx_2|_w
  LaneReals residual;       ///< max_i |H_i(x_p)|
};

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#endif
