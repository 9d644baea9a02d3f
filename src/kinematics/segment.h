// SPDX-License-Identifier: MIT
// What lies between two neighbouring points of a curve? Interpolation, the point in a plane across,
// the place of a sign change.
#pragma once

#include <functional>
#include <optional>

#include "curve.h"

namespace moivre {

/// From `a` to `b`, by x = a.tangent.(y - a.y), which goes from 0 to `length`.
struct Segment {
  CurvePoint a;
  CurvePoint b;
  double length = 0;
};

/// dy/dx and d2y/dx2 at b.
struct Slopes {
  Eigen::VectorXd slope;
  Eigen::VectorXd bend;
};
/// With x along the tangent at a, y'' at b has a part along y' that goes.
Slopes slopes_at_end(const Segment& segment);

/// Quintic through both points with their tangents and curvatures.
Eigen::VectorXd interpolated(const Segment& segment, double x);

/// The x where the interpolation's time is `time`, which lies between those of a and b (time
/// growing all the way).
double place_of_time(const Segment& segment, double time);

/// The curve's point at x; nullopt where it cannot be corrected.
std::optional<CurvePoint> point_at(const Curve& curve, const Segment& segment, double x);

/// Where `f`, positive at a and not at b, changes sign, to rounding of x.
/// nullopt where a point in between cannot be corrected.
std::optional<CurvePoint> sign_change(const Curve& curve, const Segment& segment,
                                      const std::function<double(const CurvePoint&)>& f);

}  // namespace moivre
