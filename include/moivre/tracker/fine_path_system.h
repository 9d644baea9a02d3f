// SPDX-License-Identifier: MIT
// What does the path look like near (x, t), in double-double throughout? As tracker/path_system.h, without its shortcuts.
//
//   J = [ H_x ; a ],   J dx = [ -H ; 1 - a x ]  Newton correction,   J x' = [ -H_t dt ; 0 ]  tangent
//
// a: the patch, a row that the tracker moves along with the path. The natural patch x^H would leave the scale of x to the
// predictor. With a predictor of several points, errors of scale would then grow from step to step.
// Everything is evaluated, factored and solved in double-double, with a fresh J for each correction.
#pragma once

#include "moivre/numeric/dense_lu.h"
#include "moivre/tracker/path_system.h"

namespace moivre {

/// t and 1 - t in double-double; near t = 1 from 1 - t, which has more digits there than double's t.
inline Time<ComplexDoubleDouble> fine_time(const PathTime& t) {
  constexpr double kNear = 0.25;
  const ComplexDoubleDouble one(1.0);
  if (std::norm(t.rest) < kNear) return {one - t.rest, t.rest};
  return {t.t, one - t.t};
}

/// Each coordinate rounded to double.
inline void round_into(std::span<const ComplexDoubleDouble> x, Point& rounded) {
  for (std::size_t i = 0; i < x.size(); ++i) rounded[i] = to_complex(x[i]);
}

/// When a point counts as found by Newton's method.
struct SettlingRules {
  double reach = 0;     ///< |dx_1|_w above which the point is refused
  double aim = 0;       ///< |dx_k|_w that ends it
  double rounding = 0;  ///< |dx_k|_w that passes where rounding stops it
};
/// Of a point on the way, and of a regular end at t = 1, known beyond double.
inline constexpr SettlingRules kSettledOnPath{1e-2, 1e-12, 1e-9};
inline constexpr SettlingRules kSettledAtEnd{1e-2, 1e-26, 1e-10};

/// What Newton's method did.
struct Settling {
  bool converged = false;
  double first = 0;  ///< |dx_1|_w
  double last = 0;   ///< |dx_k|_w of the last correction
  double drift = 0;  ///< max_i |H_i| before the first one
};

class FinePathSystem {
 public:
  explicit FinePathSystem(const Homotopy& homotopy);

  std::size_t coordinates() const { return n_ + 1; }

  /// The frame of the path, where the homotopy is framed; it has to stay where it is.
  void set_frame(const PathFrame* frame) { homotopy_.set_frame(frame); }

  /// a <- x^H / |x|^2.
  void set_patch(std::span<const ComplexDoubleDouble> x);

  /// Point and tangent of the same path where a x = 1.
  void bring_to_patch(std::span<ComplexDoubleDouble> x, std::span<ComplexDoubleDouble> dx) const;

  /// Evaluates H, H_x, H_t at (x, t) and factors J. False when J is singular or something is not finite.
  bool linearize(std::span<const ComplexDoubleDouble> x, const PathTime& t);

  /// x <- x + J^{-1} [-H; 1 - a x] with the last linearize(); |dx|_w of tracker/path_system.h.
  double correct(std::span<ComplexDoubleDouble> x);

  /// Newton's method from x at fixed t, x replaced. It is to contract by ten at least, as it does at no multiple root.
  Settling settle(std::span<ComplexDoubleDouble> x, const PathTime& t, const SettlingRules& rules);

  /// A point that settled at t = 1 by kSettledAtEnd: is its last correction what rounding makes of a condition that
  /// double-double can bear?
  bool is_regular_end(const Settling& settling);

  /// dx <- J^{-1} [-H_t dt; 0] with the last linearize().
  void tangent(Complex dt, std::span<ComplexDoubleDouble> dx);

  /// |J|_inf |J^{-1}|_inf of the last linearize(), rows as they are.
  double condition();

  /// max_i |H_i| of the last linearize().
  double residual() const;

  const WorkCount& work() const noexcept { return work_; }

 private:
  std::size_t n_;
  HomotopyEvaluator<ComplexDoubleDouble> homotopy_;
  DenseLu<ComplexDoubleDouble> lu_;
  std::vector<ComplexDoubleDouble> patch_;  // a
  std::vector<ComplexDoubleDouble> h_;
  std::vector<ComplexDoubleDouble> ht_;
  std::vector<ComplexDoubleDouble> dx_;
  Point rounded_x_;
  Point rounded_dx_;
  double norm_ = 0;  // |J|_inf
  WorkCount work_;
};

}  // namespace moivre
