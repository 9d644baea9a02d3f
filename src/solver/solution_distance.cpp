// SPDX-License-Identifier: MIT
// The largest parts first, which cancel.
#include "solution_distance.h"

#include <algorithm>

namespace moivre {

double distance(const Solution& a, const Solution& b) {
  Point apart(a.x.size());
  const auto add = [&](const Point& part, double sign) {
    for (std::size_t i = 0; i < part.size(); ++i) apart[i] += sign * part[i];
  };
  add(a.x, 1);
  add(b.x, -1);
  const std::size_t parts = std::max(a.finer.size(), b.finer.size());
  for (std::size_t k = 0; k < parts; ++k) {
    if (k < a.finer.size()) add(a.finer[k], 1);
    if (k < b.finer.size()) add(b.finer[k], -1);
  }
  return max_norm(apart);
}

}  // namespace moivre
