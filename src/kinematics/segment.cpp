// SPDX-License-Identifier: MIT
// Hermite's quintic, and zeros on it by the Illinois method.
#include "segment.h"

#include <cmath>

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Illinois needs under ten; bisection, its worst case, halves a step to rounding in this many.
constexpr int kIterations = 60;
// Beside the segment's length.
constexpr double kPlaceTolerance = 1e-15;

/// The zero of a function on [0, length] that is f0 > 0 at 0 and f1 <= 0 at `length`. `f` returns nullopt to give up.
template <class Function>
std::optional<double> zero(Function f, double length, double f0, double f1) {
  double left = 0;
  double right = length;
  double at_left = f0;
  double at_right = f1;
  double x = right;
  int side = 0;
  for (int k = 0; k < kIterations && right - left > kPlaceTolerance * length; ++k) {
    x = (left * at_right - right * at_left) / (at_right - at_left);
    const std::optional<double> value = f(x);
    if (!value) return std::nullopt;
    if (*value == 0) return x;
    if (*value > 0) {
      left = x;
      at_left = *value;
      if (side == 1) at_right /= 2;
      side = 1;
    } else {
      right = x;
      at_right = *value;
      if (side == -1) at_left /= 2;
      side = -1;
    }
  }
  return x;
}

/// What values, slopes and second derivatives at both ends count for at a place between.
struct Weights {
  double a, slope_a, bend_a;
  double b, slope_b, bend_b;
};

Weights weights(double x, double h) {
  const double s = x / h;
  const double r = 1 - s;
  return {r * r * r * (1 + 3 * s + 6 * s * s), h * s * r * r * r * (1 + 3 * s),
          h * h * s * s * r * r * r / 2,       s * s * s * (1 + 3 * r + 6 * r * r),
          -h * r * s * s * s * (1 + 3 * r),    h * h * r * r * s * s * s / 2};
}

}  // namespace

Slopes slopes_at_end(const Segment& segment) {
  const VectorXd& along = segment.a.tangent;
  const CurvePoint& b = segment.b;
  const double rate = along.dot(b.tangent);
  Slopes at_b{b.tangent / rate, {}};
  at_b.bend = (b.curvature - along.dot(b.curvature) * at_b.slope) / (rate * rate);
  return at_b;
}

VectorXd interpolated(const Segment& segment, double x) {
  const CurvePoint& a = segment.a;
  const CurvePoint& b = segment.b;
  const Slopes at_b = slopes_at_end(segment);
  const Weights w = weights(x, segment.length);
  return w.a * a.y + w.slope_a * a.tangent + w.bend_a * a.curvature + w.b * b.y +
         w.slope_b * at_b.slope + w.bend_b * at_b.bend;
}

double place_of_time(const Segment& segment, double time) {
  const CurvePoint& a = segment.a;
  const CurvePoint& b = segment.b;
  const Slopes at_b = slopes_at_end(segment);
  const Index last = a.y.size() - 1;
  const auto gap = [&](double x) -> std::optional<double> {
    const Weights w = weights(x, segment.length);
    return time - (w.a * a.y[last] + w.slope_a * a.tangent[last] + w.bend_a * a.curvature[last] +
                   w.b * b.y[last] + w.slope_b * at_b.slope[last] + w.bend_b * at_b.bend[last]);
  };
  const double at_a = time - a.time();
  const double behind = time - b.time();
  if (at_a <= 0) return 0;
  if (behind >= 0) return segment.length;
  return zero(gap, segment.length, at_a, behind).value_or(segment.length);
}

std::optional<CurvePoint> point_at(const Curve& curve, const Segment& segment, double x) {
  const VectorXd& normal = segment.a.tangent;
  const auto y = curve.corrected(interpolated(segment, x), normal, normal.dot(segment.a.y) + x);
  if (!y) return std::nullopt;
  return curve.next(*y, segment.a);
}

std::optional<CurvePoint> sign_change(const Curve& curve, const Segment& segment,
                                      const std::function<double(const CurvePoint&)>& f) {
  std::optional<CurvePoint> found;
  const auto value = [&](double x) -> std::optional<double> {
    found = point_at(curve, segment, x);
    if (!found) return std::nullopt;
    return f(*found);
  };
  const auto x = zero(value, segment.length, f(segment.a), f(segment.b));
  if (!x) return std::nullopt;
  return point_at(curve, segment, *x);
}

}  // namespace moivre
