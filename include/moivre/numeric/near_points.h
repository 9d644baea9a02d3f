// SPDX-License-Identifier: MIT
// Which of many points may be near this one? Those whose numbers are near its own; the others need
// no look.
//
// A point's number is one that all its coordinates have a part in: near points have near numbers,
// and others agree but by chance.
// A look costs O(log N), and O(1) for each number that is found.
// Edges: a point with a coordinate that is NaN is near none. All points of no coordinates have the
// number 0: each is near each.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "moivre/numeric/random.h"

namespace moivre {

/// max_i |x_i - y_i|, x and y of as many coordinates; 0 of none.
inline double max_distance(const Point& x, const Point& y) {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::abs(x[i] - y[i]));
  return largest;
}

/// Re of a combination of the coordinates with fixed factors of modulus 1: it moves by no more than
/// n max |dx_i|.
inline double number_of(const Point& x) {
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sum += product(random_phase(1, RandomStream::slice, k), x[k]).real();
  }
  return sum;
}

class NearNumbers {
 public:
  NearNumbers() = default;
  /// One a point; a NaN is near nothing.
  explicit NearNumbers(const std::vector<double>& numbers) {
    sorted_.reserve(numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (!std::isnan(numbers[k])) sorted_.emplace_back(numbers[k], k);
    }
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// Calls visit(number, k) for each point k that has a number, by ascending number.
  template <class Visit>
  void visit_all(const Visit& visit) const {
    for (const auto& [number, k] : sorted_) visit(number, k);
  }

  /// Calls visit(k) for each point k whose number is no farther than `reach` from this one, by
  /// ascending number.
  template <class Visit>
  void visit_near(double number, double reach, const Visit& visit) const {
    auto next =
        std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(number - reach, std::size_t{0}));
    for (; next != sorted_.end() && next->first <= number + reach; ++next) visit(next->second);
  }

 private:
  std::vector<std::pair<double, std::size_t>> sorted_;
};

}  // namespace moivre
