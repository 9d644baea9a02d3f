// SPDX-License-Identifier: MIT
// Entries, groups, cycles and missing images.
#include "path_table.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "coincidence.h"

namespace moivre {

std::string to_string(PathVerdict verdict) {
  switch (verdict) {
    case PathVerdict::open:
      return "open";
    case PathVerdict::finite:
      return "finite";
    case PathVerdict::at_infinity:
      return "at infinity";
    case PathVerdict::as_rounded:
      return "at infinity as rounded";
    case PathVerdict::not_needed:
      return "not needed";
    case PathVerdict::failed:
      return "failed";
  }
  return "";
}

PathRecord& PathTable::record(std::uint64_t path) {
  if (path >= records_.size()) records_.resize(path + 1);
  return records_[path];
}

void PathTable::decide(std::uint64_t path, PathVerdict verdict) {
  PathRecord& known = record(path);
  if (known.verdict == PathVerdict::finite) {
    roots_.erase(path);
    beside_.erase(path);
    refuted_.erase(path);
  }
  if (known.verdict == PathVerdict::failed) {
    failures_.erase(path);
    last_points_.erase(path);
  }
  if (known.verdict != PathVerdict::open) --count_[static_cast<std::size_t>(known.verdict)];
  known.verdict = verdict;
  known.by_count = false;
  ++count_[static_cast<std::size_t>(verdict)];
}

void PathTable::enter_root(std::uint64_t path, Root&& root,
                           std::shared_ptr<const Certificate> beside) {
  decide(path, PathVerdict::finite);
  roots_[path] = std::move(root);
  if (beside) beside_[path] = std::move(beside);
}

void PathTable::enter_by_count(std::uint64_t path, Root&& root) {
  enter_root(path, std::move(root));
  record(path).by_count = true;
}

bool PathTable::is_seen_at(std::uint64_t path, const Point& x) const {
  const auto root = roots_.find(path);
  return root != roots_.end() && !refuted_.contains(path) &&
         relative_distance(x, root->second.point.x) <= root->second.tolerance;
}

const Certificate* PathTable::beside(std::uint64_t path) const {
  const auto found = beside_.find(path);
  return found == beside_.end() ? nullptr : found->second.get();
}

void PathTable::enter_infinity(std::uint64_t path, bool is_as_rounded) {
  decide(path, is_as_rounded ? PathVerdict::as_rounded : PathVerdict::at_infinity);
}

void PathTable::enter_failure(const FailedPath& failure, Point last) {
  decide(failure.path, PathVerdict::failed);
  failures_[failure.path] = failure;
  if (!last.empty()) last_points_[failure.path] = std::move(last);
}

void PathTable::leave(std::uint64_t path) { decide(path, PathVerdict::not_needed); }

void PathTable::count_following(std::uint64_t path, const StepCount& count, std::size_t stage,
                                bool is_followed_on) {
  PathRecord& known = record(path);
  const std::uint64_t steps = known.steps + count.accepted + count.rejected;
  known.steps = static_cast<std::uint32_t>(
      std::min<std::uint64_t>(steps, std::numeric_limits<std::uint32_t>::max()));
  if (!is_followed_on && known.followed < std::numeric_limits<std::uint8_t>::max())
    ++known.followed;
  known.stage = static_cast<std::uint8_t>(stage);
}

PathPrecision PathTable::precision(std::uint64_t path) const {
  return path < records_.size() ? records_[path].precision : PathPrecision::double_precision;
}

std::uint64_t PathTable::count(PathVerdict verdict) const {
  return count_[static_cast<std::size_t>(verdict)];
}

std::uint64_t PathTable::tracked() const {
  return std::accumulate(count_.begin(), count_.end(), std::uint64_t{0});
}

PathGroups PathTable::groups() const {
  std::vector<const std::pair<const std::uint64_t, Root>*> ends;
  ends.reserve(roots_.size());
  for (const auto& end : roots_) {
    if (!refuted_.contains(end.first)) ends.push_back(&end);
  }
  const auto point = [&](std::size_t k) {
    const Root& root = ends[k]->second;
    return KnownPoint{&root.point.x.point(), root.tolerance};
  };
  return coincidence_groups({ends.size(), point, [&](std::size_t k) { return ends[k]->first; }});
}

std::optional<std::vector<int>> cycles(const PathTable& table, PathGroups::Group group) {
  std::map<int, int> paths_of_winding;
  for (const std::uint64_t path : group) {
    ++paths_of_winding[table.roots().at(path).winding.value_or(1)];
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

std::vector<Point> missing_conjugates(const PathTable& table) {
  std::vector<Point> images;
  std::vector<KnownPoint> points;
  images.reserve(table.roots().size());
  for (const auto& [path, root] : table.roots()) {
    if (!root.point.simple || is_real(root)) continue;
    points.push_back({&root.point.x.point(), root.tolerance});
    Point& image = images.emplace_back(root.point.x);
    for (Complex& xi : image) xi = std::conj(xi);
  }
  const std::size_t count = images.size();
  for (std::size_t k = 0; k < count; ++k) points.push_back({&images[k], points[k].tolerance});
  std::vector<Point> missing;
  for (const PathGroups::Group group : coincidence_groups(points)) {
    if (group.front() >= count) missing.push_back(images[group.front() - count]);
  }
  return missing;
}

}  // namespace moivre
