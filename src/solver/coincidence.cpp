// SPDX-License-Identifier: MIT
// Sorts points by one random projection and compares only those that it does not tell apart.
#include "coincidence.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "moivre/numeric/random.h"

namespace moivre {

double relative_distance(const Point& x, const Point& y) {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::abs(x[i] - y[i]));
  return largest / std::max(1.0, max_norm(x));
}

namespace {

/// Re of a fixed combination of the coordinates with coefficients of modulus 1/n: it moves by no
/// more than |dx|_inf.
double projection(const Point& x) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += product(random_phase(1, RandomStream::slice, i), x[i]).real();
  }
  return x.empty() ? 0 : sum / static_cast<double>(x.size());
}

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t k) {
  while (parent[k] != k) k = parent[k] = parent[parent[k]];
  return k;
}

}  // namespace

std::vector<std::vector<std::size_t>> coincidence_groups(const std::vector<KnownPoint>& points) {
  const std::size_t count = points.size();
  std::vector<double> key(count);
  std::vector<double> reach(count);
  double widest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    key[k] = projection(*points[k].x);
    reach[k] = points[k].tolerance * std::max(1.0, max_norm(*points[k].x));
    widest = std::max(widest, reach[k]);
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key[a] < key[b]; });
  std::vector<std::size_t> parent(count);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const std::size_t a = order[i];
      const std::size_t b = order[j];
      if (key[b] - key[a] > reach[a] + widest) break;
      if (relative_distance(*points[a].x, *points[b].x) <=
          points[a].tolerance + points[b].tolerance) {
        parent[root_of(parent, b)] = root_of(parent, a);
      }
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> by_root;
  for (std::size_t k = 0; k < count; ++k) by_root[root_of(parent, k)].push_back(k);
  std::vector<std::vector<std::size_t>> groups;
  for (auto& [root, group] : by_root) groups.push_back(std::move(group));
  std::sort(groups.begin(), groups.end());
  return groups;
}

}  // namespace moivre
