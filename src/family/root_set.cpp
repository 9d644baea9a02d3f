// SPDX-License-Identifier: MIT
// Points beside their projections to a line.
#include "root_set.h"

#include <algorithm>
#include <cmath>

namespace moivre {
namespace {

constexpr double kSame = 1e-6;

/// sum_j Re(x_j e^{-ij}): coordinates that are permuted or conjugate have others.
double projection(const Point& x) {
  double sum = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    sum += x[j].real() * std::cos(static_cast<double>(j)) +
           x[j].imag() * std::sin(static_cast<double>(j));
  }
  return sum;
}

}  // namespace

RootSet::RootSet(const std::vector<Point>& roots) {
  for (const Point& root : roots) add(root);
}

bool RootSet::holds(const Point& x) const {
  const double least = kSame * std::max(1.0, max_norm(x));
  const double at = projection(x);
  const double reach = static_cast<double>(x.size()) * least;
  const auto end = by_projection_.upper_bound(at + reach);
  return std::any_of(by_projection_.lower_bound(at - reach), end, [&](const auto& entry) {
    const Point& root = roots_[entry.second];
    return std::equal(x.begin(), x.end(), root.begin(),
                      [&](const Complex& a, const Complex& b) { return std::abs(a - b) <= least; });
  });
}

bool RootSet::add(Point x) {
  if (holds(x)) return false;
  by_projection_.emplace(projection(x), roots_.size());
  roots_.push_back(std::move(x));
  return true;
}

}  // namespace moivre
