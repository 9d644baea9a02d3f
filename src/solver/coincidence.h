// SPDX-License-Identifier: MIT
// Which of many points are the same point? Groups of points nearer to each other than they are
// known.
//
// Two points coincide when |x - y|_inf <= (tolerance_x + tolerance_y) max(1, |x|_inf). Groups are
// the connected components of that relation. O(N log N) unless many points share one projection.
#pragma once

#include <vector>

#include "moivre/numeric/complex.h"
#include "path_groups.h"

namespace moivre {

struct KnownPoint {
  const Point* x;
  double tolerance;  ///< relative to max(1, |x|_inf)
};

/// The paths that come to these points, as many of each; every group in their order, groups by
/// their first path; single points too.
PathGroups coincidence_groups(const std::vector<std::uint64_t>& paths,
                              const std::vector<KnownPoint>& points);
/// The same of their places among `points`.
PathGroups coincidence_groups(const std::vector<KnownPoint>& points);

/// |x - y|_inf / max(1, |x|_inf).
double relative_distance(const Point& x, const Point& y);

}  // namespace moivre
