// SPDX-License-Identifier: MIT
// Hermite's cubic, and zeros on it by the Illinois method.
#include "segment.h"

#include <cmath>

namespace moivre {
namespace {

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

}  // namespace

VectorXd interpolated(const Segment& segment, double x) {
  const CurvePoint& a = segment.a;
  const CurvePoint& b = segment.b;
  const double h = segment.length;
  const double s = x / h;
  const VectorXd slope_b = b.tangent / a.tangent.dot(b.tangent);
  return a.y * ((1 + 2 * s) * (1 - s) * (1 - s)) + b.y * (s * s * (3 - 2 * s)) +
         a.tangent * (h * s * (1 - s) * (1 - s)) - slope_b * (h * s * s * (1 - s));
}

double place_of_time(const Segment& segment, double time) {
  const auto gap = [&](double x) -> std::optional<double> {
    const VectorXd y = interpolated(segment, x);
    return time - y[y.size() - 1];
  };
  const double at_a = time - segment.a.time();
  const double at_b = time - segment.b.time();
  if (at_a <= 0) return 0;
  if (at_b >= 0) return segment.length;
  return zero(gap, segment.length, at_a, at_b).value_or(segment.length);
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
