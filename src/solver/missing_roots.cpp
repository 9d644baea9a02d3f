// SPDX-License-Identifier: MIT
// Points of the ring: simple ones proved, without those that have a path, each to the nearest path
// whose end is not.
#include "missing_roots.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "certificates.h"
#include "completeness.h"
#include "ends.h"
#include "judge.h"
#include "moivre/certify/ring_points.h"
#include "places.h"

namespace moivre {
namespace {

// Sums of doubles hold no more.
constexpr int kBitsOfPlace = 1024;

/// Of (1, x) and (1, y), by angle: roots of any size are compared. In [0, 1].
double projective_distance(const Point& x, const Point& y) {
  const double scale_x = std::max(1.0, max_norm(x)), scale_y = std::max(1.0, max_norm(y));
  Complex inner = 1 / (scale_x * scale_y);
  double size_x = 1 / (scale_x * scale_x), size_y = 1 / (scale_y * scale_y);
  for (std::size_t j = 0; j < x.size(); ++j) {
    inner += std::conj(x[j] / scale_x) * (y[j] / scale_y);
    size_x += std::norm(x[j] / scale_x);
    size_y += std::norm(y[j] / scale_y);
  }
  return std::sqrt(std::max(0.0, 1 - std::norm(inner) / (size_x * size_y)));
}

std::vector<ProvedPlace> simple_places(const Setting& setting,
                                       const std::vector<RingPoint>& points) {
  Certifier certifier(setting.certify_program);
  std::vector<ProvedPlace> places;
  for (const RingPoint& point : points) {
    if (point.exponent > 1) continue;
    Place place = place_of(setting.prepared.reduction, point.x);
    Certificate certificate;
    // Most need as many as the first; beside infinity, where the leading terms nearly vanish, it
    // takes more, and beside another root twice as many as part the two.
    for (int bits = kMostProofBits; !certificate.holds_root() && bits <= kMostArbBits; bits *= 2) {
      certificate = certifier.certify_near(place.x, place.finer, bits);
    }
    if (!certificate.holds_root()) continue;
    places.push_back({std::move(place), std::make_shared<const Certificate>(certificate), 1});
  }
  return places;
}

/// None where not all of them are known, or two are one point of double.
std::vector<ExactRoot> multiple_roots(const Run& run, const std::vector<RingPoint>& points) {
  std::vector<ExactRoot> roots;
  if (!are_multiplicities(points, run.bounds.ring.dimension)) return roots;
  for (const RingPoint& point : points) {
    if (point.exponent == 1) continue;
    Place place = place_of(run.setting.prepared.reduction, point.x);
    const bool is_taken = std::any_of(roots.begin(), roots.end(),
                                      [&](const ExactRoot& root) { return root.x == place.x; });
    if (is_taken) return {};
    roots.push_back({std::move(place.x), true, point.exponent});
  }
  return roots;
}

/// Empty where nothing was seen.
Point last_seen(const Run& run, std::uint64_t path) {
  const auto waiting = run.waiting.find(path);
  if (waiting != run.waiting.end()) return where_it_waits(run, waiting->second);
  const auto root = run.table.roots().find(path);
  if (root != run.table.roots().end()) return root->second.point.x;
  const auto last = run.table.last_points().find(path);
  return last != run.table.last_points().end() ? last->second : Point();
}

/// Of the point that was last seen of the path; 1 where nothing was.
double distance_from_end(const Run& run, std::uint64_t path, const Point& x) {
  const Point seen = last_seen(run, path);
  return seen.size() == x.size() ? projective_distance(x, seen) : 1;
}

/// At infinity within the file's digits: of the file to the letter they may lead to roots.
PathSet paths_at_infinity_as_rounded(const Run& run) {
  PathSet paths;
  if (run.table.count(PathVerdict::as_rounded) == 0) return paths;
  for (std::uint64_t path = 0; path < run.table.records().size(); ++path) {
    if (run.table.records()[path].verdict == PathVerdict::as_rounded) paths.insert(path);
  }
  return paths;
}

/// Paths that are open or wait, and those whose ends are told without a proof.
PathSet paths_without_proof(const Run& run) {
  PathSet paths = open_to_more_digits(run);
  for (const auto& [path, endgame_start] : run.waiting) paths.insert(path);
  paths.merge(paths_at_infinity_as_rounded(run));
  for (const auto& [path, root] : run.table.roots()) {
    if (!root.point.simple && !root.is_exact) paths.insert(path);
  }
  return paths;
}

void enter_nearest(Run& run, const std::vector<ProvedPlace>& places, PathSet paths) {
  Refiner refiner(run.setting.refiner_program);
  for (const ProvedPlace& place : places) {
    if (paths.empty()) break;
    std::map<double, std::uint64_t> by_distance;
    for (const std::uint64_t path : paths) {
      by_distance.emplace(distance_from_end(run, path, place.place.x), path);
    }
    const std::uint64_t nearest = by_distance.begin()->second;
    enter_place(run, refiner, nearest, place);
    run.waiting.erase(nearest);
    paths.erase(nearest);
  }
}

}  // namespace

void give_missing_roots(Run& run) {
  if (run.table.count(PathVerdict::as_rounded) > 0) look_for_ring(run);
  const QuotientRing& ring = run.bounds.ring;
  const bool can_be_found = ring.verdict == QuotientRing::Verdict::finite &&
                            ring.dimension <= kMostRingPoints && is_root_missing(run);
  const bool may_have_digits = !run.setting.trackers.finer.empty();
  if (!can_be_found || !may_have_digits || run.setting.options.every_path) return;
  const PathSet paths = paths_without_proof(run);
  const std::uint64_t terms = terms_instead_of(run, paths);
  if (terms == 0 || !run.bounds.for_roots.allows(terms)) return;
  const auto points =
      ring_points(run.setting.prepared.reduction.system, {.most_terms = terms,
                                                          .stop = &run.setting.stop,
                                                          .seed = run.setting.options.seed,
                                                          .bits = kBitsOfPlace});
  run.require_time();
  if (!points) return;
  enter_nearest(run, free_places(run, simple_places(run.setting, *points)), paths);
  run.ring_roots = multiple_roots(run, *points);
}

}  // namespace moivre
