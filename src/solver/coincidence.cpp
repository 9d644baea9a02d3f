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

/// For each point one of its group, the same for all of them.
std::vector<std::size_t> one_of_group(const std::vector<KnownPoint>& points) {
  const std::size_t count = points.size();
  std::vector<double> numbers;
  numbers.reserve(count);
  // In a number.
  const auto reach = [&](std::size_t k) {
    const auto& [x, tolerance] = points[k];
    return static_cast<double>(x->size()) * tolerance * std::max(1.0, max_norm(*x));
  };
  double widest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    numbers.push_back(number_of(*points[k].x));
    widest = std::max(widest, reach(k));
  }
  const NearNumbers near(numbers);
  std::vector<std::size_t> parent(count);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (std::size_t a = 0; a < count; ++a) {
    near.visit_near(numbers[a], reach(a) + widest, [&](std::size_t b) {
      const double known = points[a].tolerance + points[b].tolerance;
      if (relative_distance(*points[a].x, *points[b].x) > known) return;
      parent[root_of(parent, b)] = root_of(parent, a);
    });
  }
  for (std::size_t k = 0; k < count; ++k) parent[k] = root_of(parent, k);
  return parent;
}

}  // namespace

PathGroups coincidence_groups(const std::vector<std::uint64_t>& paths,
                              const std::vector<KnownPoint>& points) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  const std::vector<std::size_t> one_of = one_of_group(points);
  // A chain from each group's first point through all of them.
  std::vector<std::size_t> last(points.size(), kNone);  // by one of the group
  std::vector<std::size_t> next(points.size(), kNone);
  std::vector<bool> is_first(points.size());
  std::size_t count = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::size_t& before = last[one_of[k]];
    is_first[k] = before == kNone;
    if (is_first[k]) {
      ++count;
    } else {
      next[before] = k;
    }
    before = k;
  }
  PathGroups groups;
  groups.reserve(count, points.size());
  std::vector<std::uint64_t> group;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!is_first[k]) continue;
    group.clear();
    for (std::size_t at = k; at != kNone; at = next[at]) group.push_back(paths[at]);
    groups.add(group);
  }
  return groups;
}

PathGroups coincidence_groups(const std::vector<KnownPoint>& points) {
  std::vector<std::uint64_t> places(points.size());
  std::iota(places.begin(), places.end(), std::uint64_t{0});
  return coincidence_groups(places, points);
}

}  // namespace moivre
