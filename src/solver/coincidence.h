// SPDX-License-Identifier: MIT
// Which of many points are the same point? Groups of points nearer to each other than they are
// known.
//
// Two points coincide when |x - y|_inf <= (tolerance_x + tolerance_y) max(1, |x|_inf). Groups are
// the connected components of that relation. O(N log N) unless many points share one projection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "moivre/numeric/complex.h"
#include "path_groups.h"

namespace moivre {

struct KnownPoint {
  const Point* x;
  double tolerance;  ///< relative to max(1, |x|_inf)
};

/// Points and the paths that come to them, read where they are kept: of a million no list is made.
struct PointsOfPaths {
  std::size_t count = 0;
  std::function<KnownPoint(std::size_t)> point;
  std::function<std::uint64_t(std::size_t)> path;
};

/// Paths; every group in the points' order, groups by their first point; single points too.
PathGroups coincidence_groups(const PointsOfPaths& points);
/// The same of their places among `points`.
PathGroups coincidence_groups(const std::vector<KnownPoint>& points);

/// |x - y|_inf / max(1, |x|_inf).
double relative_distance(const Point& x, const Point& y);

}  // namespace moivre
