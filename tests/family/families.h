// SPDX-License-Identifier: MIT
// Which families do several tests solve? Two circles, a four-bar, and members with random
// parameters.
#pragma once

#include <algorithm>

#include "moivre/family/learn.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/read.h"

namespace moivre {

/// A conic and a circle: four roots of a generic member.
inline Family conics() {
  return unlearned_family(
      read_system({"test", "2 5\na*x^2 + b*x*y + y^2 - c; x^2 + y^2 - x - 1;\n"}),
      {{"a"}, {"b"}, {"c"}});
}

/// r e^{i q} = d + l u - m v around the loop, and its conjugate; u = e^{i..}, v unknown: two roots.
/// The coupler's and the rocker's directions of a four-bar whose crank stands at `w`, its conjugate
/// W.
inline Family four_bar() {
  return unlearned_family(
      read_system({"test", "2 8\nr*w + l*u - m*v - d; r*W*u*v + l*v - m*u - d*u*v;\n"}),
      {{"r"}, {"l"}, {"m"}, {"d"}, {"w"}, {"W"}});
}

/// The k-th random real member, coordinates in [-2, 2].
inline Point random_member(std::size_t parameters, std::uint64_t k) {
  Point p;
  for (std::size_t j = 0; j < parameters; ++j) {
    p.push_back(4 * random_unit(7, RandomStream::test, k * parameters + j) - 2);
  }
  return p;
}

inline std::vector<Point> random_members(std::size_t parameters, std::size_t count) {
  std::vector<Point> members;
  for (std::size_t k = 0; k < count; ++k) members.push_back(random_member(parameters, k));
  return members;
}

/// Every point of a is near one of b, and there are as many.
inline bool are_same(const std::vector<Point>& a, const std::vector<Point>& b, double tolerance) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const Point& x) {
           return std::any_of(b.begin(), b.end(), [&](const Point& y) {
             double largest = 0;
             for (std::size_t j = 0; j < x.size(); ++j) {
               largest = std::max(largest, std::abs(x[j] - y[j]));
             }
             return largest <= tolerance * std::max(1.0, max_norm(x));
           });
         });
}

}  // namespace moivre
