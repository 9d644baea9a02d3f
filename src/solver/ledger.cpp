// SPDX-License-Identifier: MIT
// Entries, groups, cycles and missing images.
#include "ledger.h"

#include <algorithm>

#include "coincidence.h"

namespace moivre {

void Ledger::enter_root(std::uint64_t path, Root&& root) { roots_[path] = std::move(root); }
void Ledger::enter_infinity(std::uint64_t) { ++at_infinity_; }
void Ledger::enter_failure(const FailedPath& failure) { failures_[failure.path] = failure; }

void Ledger::strike(std::uint64_t path) {
  if (roots_.erase(path) == 0 && failures_.erase(path) == 0) --at_infinity_;
}

std::vector<std::vector<std::uint64_t>> Ledger::groups() const {
  std::vector<std::uint64_t> paths;
  std::vector<KnownPoint> points;
  for (const auto& [path, root] : roots_) {
    paths.push_back(path);
    points.push_back({&root.point.x, root.tolerance});
  }
  std::vector<std::vector<std::uint64_t>> groups;
  for (const auto& indices : coincidence_groups(points)) {
    auto& group = groups.emplace_back();
    for (const std::size_t k : indices) group.push_back(paths[k]);
  }
  return groups;
}

std::optional<std::vector<int>> cycles(const Ledger& ledger,
                                       const std::vector<std::uint64_t>& group) {
  std::map<int, int> paths_of_winding;
  for (const std::uint64_t path : group) {
    ++paths_of_winding[ledger.roots().at(path).winding.value_or(1)];
  }
  std::vector<int> result;
  for (const auto& [winding, count] : paths_of_winding) {
    if (count % winding != 0) return std::nullopt;
    result.insert(result.end(), static_cast<std::size_t>(count / winding), winding);
  }
  return result;
}

bool is_real(const Root& root) {
  const Reality proved = root.certificate ? root.certificate->reality : Reality::unknown;
  if (proved != Reality::unknown) return proved == Reality::real;
  const Point& x = root.point.x;
  const double size = std::max(1.0, max_norm(x));
  return std::all_of(x.begin(), x.end(), [&](const Complex& xi) {
    return std::abs(xi.imag()) <= 2 * root.point.accuracy * size;
  });
}

std::vector<Point> missing_conjugates(const Ledger& ledger) {
  std::vector<Point> images;
  std::vector<KnownPoint> points;
  images.reserve(ledger.roots().size());
  for (const auto& [path, root] : ledger.roots()) {
    if (!root.point.simple || is_real(root)) continue;
    points.push_back({&root.point.x, root.tolerance});
    Point& image = images.emplace_back(root.point.x);
    for (Complex& xi : image) xi = std::conj(xi);
  }
  const std::size_t count = images.size();
  for (std::size_t k = 0; k < count; ++k) points.push_back({&images[k], points[k].tolerance});
  std::vector<Point> missing;
  for (const auto& group : coincidence_groups(points)) {
    if (group.front() >= count) missing.push_back(images[group.front() - count]);
  }
  return missing;
}

}  // namespace moivre
