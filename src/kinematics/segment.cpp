// SPDX-License-Identifier: MIT
// Hermite's quintic, and zeros on it.
#include "segment.h"

#include "moivre/numeric/quintic.h"
#include "moivre/numeric/zero_between.h"

namespace moivre {

using Eigen::Index;
using Eigen::VectorXd;

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
  const QuinticWeights<double> w = quintic_weights(x, segment.length);
  return w.a * a.y + w.slope_a * a.tangent + w.bend_a * a.curvature + w.b * b.y +
         w.slope_b * at_b.slope + w.bend_b * at_b.bend;
}

double place_of_time(const Segment& segment, double time) {
  const CurvePoint& a = segment.a;
  const CurvePoint& b = segment.b;
  const Slopes at_b = slopes_at_end(segment);
  const Index last = a.y.size() - 1;
  const auto gap = [&](double x) {
    const QuinticWeights<double> w = quintic_weights(x, segment.length);
    return time - (w.a * a.y[last] + w.slope_a * a.tangent[last] + w.bend_a * a.curvature[last] +
                   w.b * b.y[last] + w.slope_b * at_b.slope[last] + w.bend_b * at_b.bend[last]);
  };
  const double at_a = time - a.time();
  const double behind = time - b.time();
  if (at_a <= 0) return 0;
  if (behind >= 0) return segment.length;
  return zero_between(gap, 0, segment.length, at_a, behind);
}

std::optional<CurvePoint> point_at(const Curve& curve, const Segment& segment, double x) {
  const VectorXd& normal = segment.a.tangent;
  const auto y = curve.corrected(interpolated(segment, x), normal, normal.dot(segment.a.y) + x);
  if (!y) return std::nullopt;
  return curve.next(*y, segment.a);
}

std::optional<CurvePoint> sign_change(const Curve& curve, const Segment& segment,
                                      const std::function<double(const CurvePoint&)>& f) {
  bool is_lost = false;
  const auto value = [&](double x) {
    const auto point = point_at(curve, segment, x);
    is_lost = !point;
    return point ? f(*point) : 0;
  };
  const double x = zero_between(value, 0, segment.length, f(segment.a), f(segment.b));
  return is_lost ? std::nullopt : point_at(curve, segment, x);
}

}  // namespace moivre
