// SPDX-License-Identifier: MIT
// Points are compared only where their numbers do not tell them apart.
#include "coincidence.h"

#include <algorithm>
#include <numeric>

#include "moivre/numeric/near_points.h"

namespace moivre {

double relative_distance(const Point& x, const Point& y) {
  return max_distance(x, y) / std::max(1.0, max_norm(x));
}

namespace {

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t k) {
  while (parent[k] != k) k = parent[k] = parent[parent[k]];
  return k;
}

/// For each point the first one of its group.
std::vector<std::size_t> first_of_group(const PointsOfPaths& points) {
  // In a number.
  const auto reach = [](const KnownPoint& point) {
    const auto& [x, tolerance] = point;
    return static_cast<double>(x->size()) * tolerance * std::max(1.0, max_norm(*x));
  };
  double widest = 0;
  const auto near = [&] {
    std::vector<double> numbers;
    numbers.reserve(points.count);
    for (std::size_t k = 0; k < points.count; ++k) {
      const KnownPoint point = points.point(k);
      numbers.push_back(number_of(*point.x));
      widest = std::max(widest, reach(point));
    }
    return NearNumbers(numbers);
  }();
  std::vector<std::size_t> parent(points.count);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  near.visit_all([&](double number, std::size_t a) {
    const KnownPoint here = points.point(a);
    near.visit_near(number, reach(here) + widest, [&](std::size_t b) {
      if (a == b) return;
      const KnownPoint there = points.point(b);
      if (relative_distance(*here.x, *there.x) > here.tolerance + there.tolerance) return;
      const std::size_t one = root_of(parent, a);
      const std::size_t other = root_of(parent, b);
      parent[std::max(one, other)] = std::min(one, other);
    });
  });
  for (std::size_t k = 0; k < points.count; ++k) parent[k] = root_of(parent, k);
  return parent;
}

}  // namespace

PathGroups coincidence_groups(const PointsOfPaths& points) {
  const std::vector<std::size_t> first = first_of_group(points);
  // Nearly every point is the first one of its group.
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < points.count; ++k) {
    if (first[k] != k) others.push_back(k);
  }
  std::stable_sort(others.begin(), others.end(),
                   [&](std::size_t a, std::size_t b) { return first[a] < first[b]; });
  PathGroups groups;
  groups.reserve(points.count - others.size(), points.count);
  std::vector<std::uint64_t> group;
  auto next = others.begin();
  for (std::size_t k = 0; k < points.count; ++k) {
    if (first[k] != k) continue;
    group.assign(1, points.path(k));
    for (; next != others.end() && first[*next] == k; ++next) group.push_back(points.path(*next));
    groups.add(group);
  }
  return groups;
}

PathGroups coincidence_groups(const std::vector<KnownPoint>& points) {
  return coincidence_groups({points.size(), [&](std::size_t k) { return points[k]; },
                             [](std::size_t k) { return std::uint64_t{k}; }});
}

}  // namespace moivre
