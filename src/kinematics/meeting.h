// SPDX-License-Identifier: MIT
// Where do branches cross ahead? Points on the way there, extrapolated to where the smallest
// singular value is 0.
//
// sigma, of [Phi_q Phi_t] with rows of length 1, falls like a whole power of the remaining
// distance: 1 where branches cross, 2 where they touch, and so on. tau = sigma^(1 / power) falls
// like the distance, and the polynomial in tau through the points gives the place at tau = 0. A
// point on the curve is known to 1e-16 / sigma only, and one far off does not show sigma's shape.
// So the power and the points are chosen whose place is in least doubt: what the farthest point
// changes, and what rounding does by the weights.
// Edges: a higher power has to be clearly better, since it fits the lower ones' way too.
#pragma once

#include <limits>
#include <vector>

#include "curve.h"

namespace moivre {

/// Where the way points to.
struct Meeting {
  Eigen::VectorXd y;
  double doubt =
      std::numeric_limits<double>::infinity();  ///< how far off, by the points and by rounding
  int order = 1;                                ///< the power
};

/// `approach`: the last points, one or more, sigma falling.
Meeting meeting_of(const std::vector<CurvePoint>& approach, const Curve& curve);

}  // namespace moivre
