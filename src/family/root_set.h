// SPDX-License-Identifier: MIT
// Is this root among many others? Points in the order they were added, none twice.
//
// Two points are one where |x - y|_inf <= 1e-6 max(1, |x|_inf): regular roots of a generic member
// lie farther apart. O(log N) a question:
// points are sorted by one projection, of which coinciding points differ by no more than n times
// their distance.
// Private to the module.
#pragma once

#include <map>
#include <vector>

#include "moivre/numeric/complex.h"

namespace moivre {

class RootSet {
 public:
  RootSet() = default;
  explicit RootSet(const std::vector<Point>& roots);

  bool holds(const Point& x) const;
  /// False where it is there already.
  bool add(Point x);
  std::size_t size() const { return roots_.size(); }
  const std::vector<Point>& roots() const { return roots_; }

 private:
  std::vector<Point> roots_;
  std::multimap<double, std::size_t> by_projection_;
};

}  // namespace moivre
