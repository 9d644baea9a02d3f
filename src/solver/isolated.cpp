// SPDX-License-Identifier: MIT
// The isolated roots brought back to the system as given, each to the nearest path in doubt.
#include "isolated.h"

#include <algorithm>
#include <limits>

#include "certificates.h"
#include "coincidence.h"
#include "ends.h"
#include "judge.h"
#include "moivre/certify/distinct.h"
#include "moivre/certify/isolate.h"
#include "moivre/numeric/near_points.h"
#include "places.h"

namespace moivre {
namespace {

// What was seen of a path's end is no farther from its root, relative to max(1, |x|_inf). Of a path
// that has no end in any digits a point on the way was seen, which tells no more than which root is
// nearest.
constexpr double kFarthestEnd = 0.1;

/// Where nothing was eliminated the disc is the certificate.
Certificate certificate_of(const IsolatedRoot& root, const Place& place, int bits) {
  Certificate result;
  result.verdict = Verdict::certified;
  result.bits = bits;
  result.midpoint = place.x;
  result.finer.assign(place.finer.begin(), place.finer.end());
  result.sizes.assign({&root.radius, 1}, {&root.error, 1});
  if (!result.sizes.are_apart()) return {};
  const ProvedCoordinate coordinate{enclosure(result, 0), root.radius};
  const std::size_t itself = 0;
  result.reality = reality_of(std::span(&coordinate, 1), std::span(&itself, 1));
  return result;
}

/// nullopt where a simple root is not proved on the system as given, or two multiple ones are one
/// point of double.
std::optional<std::vector<ProvedPlace>> places_of(const Setting& setting,
                                                  const std::vector<IsolatedRoot>& roots,
                                                  int bits) {
  const Reduction& reduction = setting.prepared.reduction;
  Certifier certifier(setting.certify_program);
  std::vector<ProvedPlace> places;
  for (const IsolatedRoot& root : roots) {
    ProvedPlace& proved = places.emplace_back();
    proved.place = place_of(reduction, {root.parts});
    proved.multiplicity = root.multiplicity;
    if (root.multiplicity > 1) {
      const bool is_taken = std::any_of(places.begin(), places.end() - 1, [&](const auto& other) {
        return other.multiplicity > 1 && other.place.x == proved.place.x;
      });
      if (is_taken) return std::nullopt;
      continue;
    }
    const Certificate certificate =
        reduction.substitutions.empty()
            ? certificate_of(root, proved.place, bits)
            : certifier.certify_near(proved.place.x, proved.place.finer, bits);
    if (!certificate.holds_root()) return std::nullopt;
    proved.certificate = std::make_shared<const Certificate>(certificate);
  }
  return places;
}

/// Those that the paths in doubt may end at: all, or the multiple ones where as many simple ones
/// are proved as there are.
std::optional<std::vector<ProvedPlace>> proved_places(const Run& run) {
  const Setting& setting = run.setting;
  const System& f = setting.prepared.reduction.system;
  // Twice as many where roots are nearer than these part.
  for (int bits = kMostProofBits; bits <= kMostArbBits && !setting.stop; bits *= 2) {
    const auto isolated = isolated_roots(f.polynomials.front(), bits);
    if (!isolated) continue;
    if (isolated->other_simple > 0 && proved_roots(run) < isolated->other_simple) {
      return std::nullopt;
    }
    if (auto places = places_of(setting, isolated->roots, bits)) return places;
  }
  return std::nullopt;
}

/// A path and the last that was seen of it.
struct SeenPath {
  std::uint64_t path;
  Point x;
  bool is_near_its_root = true;
};

/// The paths that have no root of their own.
struct PathsInDoubt {
  std::vector<SeenPath> seen;
  /// Those that jumped to another path's root, or were last seen before the last stage: nothing
  /// tells where theirs are.
  std::vector<std::uint64_t> unseen;
};

PathsInDoubt paths_in_doubt(const Run& run) {
  const JudgedEnds judged = judge_ends_alone(run);
  PathsInDoubt paths;
  for (const auto& [path, root] : run.table.roots()) {
    if (!root.certificate) {
      paths.seen.push_back({path, root.point.x});
    } else if (judged.open.contains(path)) {
      paths.unseen.push_back(path);
    }
  }
  for (const auto& [path, failure] : run.table.failures()) {
    const auto last = run.table.last_points().find(path);
    if (last != run.table.last_points().end()) {
      paths.seen.push_back({path, last->second, !run.in_all_digits.contains(path)});
    } else {
      paths.unseen.push_back(path);
    }
  }
  return paths;
}

/// The path that was last seen nearest to x, else one that was not seen; it is in doubt no longer.
std::optional<std::uint64_t> take_path(PathsInDoubt& paths, const Point& x) {
  auto& [seen, unseen] = paths;
  const auto nearest = std::min_element(seen.begin(), seen.end(), [&](auto& a, auto& b) {
    return max_distance(x, a.x) < max_distance(x, b.x);
  });
  const auto may_end_there = [&](const SeenPath& last) {
    return !last.is_near_its_root || relative_distance(x, last.x) <= kFarthestEnd;
  };
  std::optional<std::uint64_t> path;
  if (nearest != seen.end() && may_end_there(*nearest)) {
    path = nearest->path;
    seen.erase(nearest);
  } else if (!unseen.empty()) {
    path = unseen.back();
    unseen.pop_back();
  }
  return path;
}

}  // namespace

void isolate_roots(Run& run) {
  const Setting& setting = run.setting;
  if (setting.prepared.reduction.system.variables.size() != 1) return;
  PathsInDoubt paths = paths_in_doubt(run);
  if (paths.seen.empty() && paths.unseen.empty()) return;
  const auto places = proved_places(run);
  if (!places) return;
  std::vector<std::pair<std::uint64_t, const ProvedPlace*>> found;
  const std::vector<ProvedPlace> left = free_places(run, *places);
  for (const ProvedPlace& place : left) {
    for (std::uint64_t k = 0; k < place.multiplicity; ++k) {
      const auto path = take_path(paths, place.place.x);
      if (!path) return;
      found.emplace_back(*path, &place);
    }
  }
  if (!paths.seen.empty() || !paths.unseen.empty()) return;
  Refiner refiner(setting.refiner_program);
  for (const auto& [path, place] : found) enter_place(run, refiner, path, *place);
}

}  // namespace moivre
