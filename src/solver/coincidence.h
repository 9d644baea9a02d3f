// SPDX-License-Identifier: MIT
// Which of many points are the same point? Groups of points nearer to each other than they are
// known.
//
// Two points coincide when |x - y|_inf <= (tolerance_x + tolerance_y) max(1, |x|_inf). Groups are
// the connected components of that relation. O(N log N) unless many points share one projection.
#pragma once

#include <vector>

#include "moivre/numeric/complex.h"

namespace moivre {

struct KnownPoint {
  const Point* x;
  double tolerance;  ///< relative to max(1, |x|_inf)
};

/// For each point the number of its group, counted from 0 in the order of their first points.
std::vector<std::size_t> coincidence_numbers(const std::vector<KnownPoint>& points);

/// Indices into `points`, every group ascending, groups by their first index; single points too.
std::vector<std::vector<std::size_t>> coincidence_groups(const std::vector<KnownPoint>& points);

/// |x - y|_inf / max(1, |x|_inf).
double relative_distance(const Point& x, const Point& y);

}  // namespace moivre
