// SPDX-License-Identifier: MIT
// Doubtful paths: found in the ledger, followed again, and counted as failed where nothing helps.
#include "doubts.h"

#include <algorithm>
#include <functional>
#include <map>

#include "certificates.h"
#include "clusters.h"
#include "coincidence.h"
#include "completeness.h"
#include "exact_roots.h"
#include "isolated.h"
#include "missing_roots.h"
#include "tracking.h"

namespace moivre {
namespace {

// So many paths go ahead in more digits than double-double.
constexpr std::size_t kFirstAhead = 2;
// So many that end at one point of a set, one at a time.
constexpr std::size_t kMostOfOneEnd = 4;
// The mean of sheets that circles have closed, relative to its size.
constexpr double kMeanIsKnownTo = 1e-10;

/// The paths of a group whose ends are simple roots, and those whose ends are not. Where there are both, several roots lie
/// nearer to each other than the latter are known: no path but one ends at a simple root.
struct Ends {
  std::vector<std::uint64_t> simple;
  std::vector<std::uint64_t> singular;
  bool are_mixed() const { return !simple.empty() && !singular.empty(); }
};

Ends ends_of(const Run& run, const std::vector<std::uint64_t>& group) {
  Ends ends;
  for (const std::uint64_t path : group) {
    (run.ledger.roots().at(path).point.simple ? ends.simple : ends.singular).push_back(path);
  }
  return ends;
}

/// The paths of isolated ends at which several meet and some show no simple root: those, by the first of them.
std::map<std::uint64_t, PathSet> clusters_in(const Run& run) {
  std::map<std::uint64_t, PathSet> clusters;
  for (const auto& group : groups_of(run)) {
    const Ends ends = ends_of(run, group);
    if (group.size() == 1 || ends.singular.empty()) continue;
    const std::uint64_t first = ends.singular.front();
    const Root& end = run.ledger.roots().at(first);
    if (end.is_exact || is_on_set(run, end)) continue;
    clusters[first] = {ends.singular.begin(), ends.singular.end()};
  }
  return clusters;
}

/// Of each cluster one path goes ahead to a regular end: where it finds one, so do the others, which are returned.
PathSet climb_to_simple_roots(Run& run, const std::map<std::uint64_t, PathSet>& clusters,
                              const std::function<void(const PathSet& paths)>& climb_these) {
  PathSet first;
  for (const auto& [path, cluster] : clusters) first.insert(path);
  climb_these(first);
  PathSet others;
  for (const auto& [path, cluster] : clusters) {
    const auto root = run.ledger.roots().find(path);
    if (root == run.ledger.roots().end() || !root->second.point.simple) continue;
    others.insert(std::next(cluster.begin()), cluster.end());
  }
  climb_these(others);
  return others;
}

/// Simple roots nearer to each other than double can tell pass for one singular root, but not in double-double.
void resolve_clusters(Run& run) {
  climb_to_simple_roots(run, clusters_in(run),
                        [&](const PathSet& paths) { climb(run, paths, Taken::regular_ends); });
}

PathSet paths_failed_by(const Run& run, Failure reason) {
  PathSet paths;
  for (const auto& [path, failure] : run.ledger.failures()) {
    if (failure.failure == reason) paths.insert(path);
  }
  return paths;
}

bool is_in_doubt(const Run& run, const std::vector<std::uint64_t>& group) {
  const Ends ends = ends_of(run, group);
  if (ends.singular.empty()) return group.size() > 1;
  const bool is_whole = group.size() > 1 && !ends.are_mixed() && cycles(run.ledger, group);
  return !is_whole && !is_on_set(run, run.ledger.roots().at(ends.singular.front()));
}

/// Failed paths of `beyond` are not asked for again.
PathSet doubtful_paths(const Run& run, const PathSet& beyond) {
  PathSet doubtful;
  for (const auto& [path, failure] : run.ledger.failures()) {
    if (!beyond.contains(path)) doubtful.insert(path);
  }
  for (const auto& group : groups_of(run)) {
    if (is_in_doubt(run, group)) doubtful.insert(group.begin(), group.end());
  }
  // Two paths on one sheet: one of them has jumped.
  for (const std::uint64_t path : run.sheets.shared()) doubtful.insert(path);
  return doubtful;
}

void fail(Run& run, std::uint64_t path, Failure reason) {
  run.ledger.enter_failure({path, reason, 1});
}

/// One path alone cannot end at an isolated root that is not simple, nor can paths that end beside a simple root, nor any that
/// make no whole cycles: what they end at is no root that this precision can show. And two paths cannot end at one simple
/// root: all but the first are lost.
void fail_unsettled(Run& run) {
  for (const auto& group : groups_of(run)) {
    if (!is_in_doubt(run, group)) continue;
    for (const std::uint64_t path : ends_of(run, group).singular) {
      fail(run, path, Failure::precision);
    }
  }
  for (const auto& group : groups_of(run)) {
    for (std::size_t k = 1; k < group.size(); ++k) {
      if (run.ledger.roots().at(group[k]).point.simple) fail(run, group[k], Failure::jumped);
    }
  }
  for (const std::uint64_t path : run.sheets.shared()) {
    if (!run.ledger.failures().contains(path)) fail(run, path, Failure::jumped);
  }
}

/// The certified roots, and the multiple ones to which whole cycles lead, are as many as exact algebra counts: the paths still in doubt
/// lead to none. No proof: of a multiple root the paths tell that it is one.
bool settle_by_count(Run& run) {
  if (run.interrupted || !are_as_counted(run)) return false;
  const auto groups = groups_of(run);
  const auto in_doubt = [&](const auto& group) { return is_in_doubt(run, group); };
  if (std::any_of(groups.begin(), groups.end(), in_doubt)) return false;
  PathSet left;
  for (const auto& [path, failure] : run.ledger.failures()) left.insert(path);
  for (const std::uint64_t path : left) run.ledger.leave(path);
  return true;
}

bool is_settled(Run& run) { return settle_by_bound(run) || settle_by_count(run); }

/// The paths to ends on sets of this kind.
PathSet paths_to_sets(const Run& run, SetHere kind) {
  PathSet paths;
  for (const auto& group : groups_of(run)) {
    const Ends ends = ends_of(run, group);
    if (ends.singular.empty()) continue;
    if (set_of(run, run.ledger.roots().at(ends.singular.front())) != kind) continue;
    paths.insert(ends.singular.begin(), ends.singular.end());
  }
  return paths;
}

/// Where F all but vanishes along a set, simple roots pass for points of it. Paths to such a set are followed in double-double: a root
/// that is proved at the end of one is none of the set's. Where there is such a root the set is none, and what the other paths end at
/// is not known.
void resolve_blurred_sets(Run& run) {
  const PathSet paths = paths_to_sets(run, SetHere::blurred);
  climb(run, paths, Taken::regular_ends);
  PathSet left;
  for (const std::uint64_t path : paths) {
    const auto root = run.ledger.roots().find(path);
    if (root != run.ledger.roots().end() && !root->second.point.simple) left.insert(path);
  }
  if (run.interrupted || left.size() == paths.size()) return;
  for (const std::uint64_t path : left) fail(run, path, Failure::precision);
  fail_unsettled(run);
}

/// After all care. More digits save no steps: where the caller's budget ended a path it stays ended.
PathSet unsettled_paths(const Run& run, const PathSet& beyond = {}) {
  PathSet paths = doubtful_paths(run, beyond);
  for (const std::uint64_t path : paths_failed_by(run, Failure::step_limit)) paths.erase(path);
  return paths;
}

/// In double-double a path may turn out to end where another was thought to: that one is followed next. Each is once.
void climb_last(Run& run, PathSet climbed) {
  while (!run.interrupted) {
    PathSet last = unsettled_paths(run, climbed);
    for (const std::uint64_t path : climbed) last.erase(path);
    if (last.empty()) return;
    climb(run, last);
    climbed.merge(last);
  }
}

bool has_climbed_to_a_simple_root(const Run& run, std::uint64_t path) {
  const auto root = run.ledger.roots().find(path);
  return root != run.ledger.roots().end() && root->second.point.simple &&
         run.ledger.rung(path) == Rung::multiprecision;
}

bool has_helped(const Run& run, const PathSet& ahead) {
  return std::any_of(ahead.begin(), ahead.end(),
                     [&](auto path) { return has_climbed_to_a_simple_root(run, path); });
}

/// Some go ahead, then twice as many, as long as one of the last ones has found a root or `goes_on`, and something is in doubt. A path that
/// ends at no simple root costs as much as thousands in double.
void climb_while_it_helps(Run& run, const Tracker& tracker, const PathSet& paths,
                          const std::function<bool()>& goes_on) {
  std::size_t together = kFirstAhead;
  for (auto next = paths.begin(); next != paths.end() && !run.interrupted; together *= 2) {
    PathSet ahead;
    while (next != paths.end() && ahead.size() < together) ahead.insert(*next++);
    climb_beyond_double_double(run, tracker, ahead);
    if (has_helped(run, ahead) ? is_settled(run) : !goes_on()) return;
  }
}

/// Simple roots that double-double cannot part, by more digits, which save no steps.
void climb_to_clusters(Run& run) {
  for (const auto& tracker : run.setting.trackers.finer) {
    climb_while_it_helps(run, *tracker, unsettled_paths(run), [&] { return is_root_missing(run); });
    if (run.interrupted || is_settled(run)) return;
  }
}

void fail_all(Run& run, const std::vector<std::uint64_t>& group) {
  for (const std::uint64_t path : group) fail(run, path, Failure::precision);
}

/// A simple root so near to a set that double does not tell it from the set's points: its sheet and one of the set's seem to meet, or the end
/// may as well be a root that is proved beside it and that no path has. In more digits its path has a regular end.
/// Or a multiple root: its sheets and one of the set's seem to meet at their mean, which is neither. In more digits the latter has a regular
/// end elsewhere.
class MeetingSheets {
 public:
  explicit MeetingSheets(Run& run) : run_(run) {
    for (const std::uint64_t path : paths()) before_.emplace(path, root(path));
  }

  /// In double-double: all, where they go together, else a few of one end. Then the first ones in more digits as long as that helps; all of
  /// them as long as a root is missing.
  void follow() {
    const Trackers& trackers = run_.setting.trackers;
    if (trackers.fine_lanes) {
      climb_together(run_, paths(), Taken::regular_ends);
    } else {
      climb(run_, first_of_one_end(), Taken::regular_ends);
    }
    for (const auto& tracker : trackers.finer) {
      climb_while_it_helps(run_, *tracker, paths(), [&] { return is_root_missing(run_); });
      if (!is_root_missing(run_)) return;
    }
  }

  /// Where no simple root is proved the end is what it was. But where a path has a regular end elsewhere its circles were none: what the
  /// others of them end at is not known, nor what two end at that come to one place.
  void judge() {
    std::map<std::uint64_t, Point> elsewhere;
    for (const auto& [path, before] : before_) {
      if (!run_.ledger.failures().contains(path)) continue;
      if (ends_elsewhere(path)) elsewhere.emplace(path, run_.ledger.last_points().at(path));
      run_.ledger.enter_root(path, Root(before));
    }
    for (const auto& [path, before] : before_) {
      const auto now = run_.ledger.roots().find(path);
      if (now == run_.ledger.roots().end() || now->second.point.simple) continue;
      if (is_broken(path, elsewhere)) fail(run_, path, Failure::precision);
    }
    const PathSet left = paths();
    for (const std::uint64_t path : left) {
      if (misses_a_root(path)) fail(run_, path, Failure::precision);
    }
    for (const auto& group : groups_of(run_)) {
      // Paths to a set end at different points of it: two at one may be at a multiple root.
      const bool is_crowded = group.size() > 1 && is_on_set(run_, root(group.front()));
      if (!is_crowded && !left.contains(group.front())) continue;
      if (is_exactly_isolated(run_.setting.f, root(group.front()))) fail_all(run_, group);
    }
  }

 private:
  const Root& root(std::uint64_t path) const { return run_.ledger.roots().at(path); }

  bool misses_a_root(std::uint64_t path) const {
    const auto& beside = root(path).beside;
    return beside && !is_held(run_, *beside);
  }

  PathSet paths() const {
    PathSet paths = paths_to_sets(run_, SetHere::sharp);
    if (is_root_missing(run_)) return paths;
    std::erase_if(paths, [&](std::uint64_t path) {
      return root(path).winding.value_or(1) == 1 && !misses_a_root(path);
    });
    return paths;
  }

  PathSet first_of_one_end() const {
    const PathSet all = paths();
    PathSet first;
    for (const auto& group : groups_of(run_)) {
      for (const std::uint64_t path : group) {
        if (all.contains(path) && first.size() < kMostOfOneEnd) first.insert(path);
      }
      if (!first.empty()) break;
    }
    return first;
  }

  /// Another path of its circle ends elsewhere; or at its own place, where it does so itself.
  bool is_broken(std::uint64_t path, const std::map<std::uint64_t, Point>& elsewhere) const {
    const Root& before = before_.at(path);
    const auto own = elsewhere.find(path);
    return std::any_of(elsewhere.begin(), elsewhere.end(), [&](const auto& other) {
      if (other.first == path) return false;
      return own == elsewhere.end()
                 ? relative_distance(before.point.x, other.second) <= before.tolerance
                 : relative_distance(own->second, other.second) <= kMeanIsKnownTo;
    });
  }

  bool ends_elsewhere(std::uint64_t path) const {
    const auto known = before_.find(path);
    const auto last = run_.ledger.last_points().find(path);
    return known != before_.end() && last != run_.ledger.last_points().end() &&
           relative_distance(last->second, known->second.point.x) > kMeanIsKnownTo;
  }

  Run& run_;
  std::map<std::uint64_t, Root> before_;
};

void look_beside_sets(Run& run) {
  MeetingSheets sheets(run);
  sheets.follow();
  sheets.judge();
}

/// Whether the paths that end there are as many as exact algebra counts of a root that is known exactly.
bool is_counted_exactly(Run& run, const Root& end, std::size_t paths) {
  const std::vector<ExactRoot> exact = exact_roots(run);
  return std::any_of(exact.begin(), exact.end(), [&](const ExactRoot& root) {
    return root.multiplicity == paths && relative_distance(root.x, end.point.x) <= end.tolerance;
  });
}

/// With all care, but for the paths that went ahead in more digits.
void follow_with_care(Run& run, const PathSet& beyond) {
  const SolveOptions& options = run.setting.options;
  const PathSet doubtful = doubtful_paths(run, beyond);
  if (run.interrupted || doubtful.empty() || options.care >= options.maximum_care) return;
  track_again(run, doubtful, options.maximum_care);
  if (!run.setting.trackers.fine_lanes) climb(run, paths_failed_by(run, Failure::precision));
}

/// In double, with more care, and in more digits.
void settle_ends(Run& run) {
  if (is_settled(run)) return;
  resolve_clusters(run);
  // Where many paths go at once digits cost less than care, and care helps none that they do not.
  const PathSet beyond = climb_together(run, paths_failed_by(run, Failure::precision));
  if (run.interrupted || is_settled(run)) return;
  follow_with_care(run, beyond);
  if (run.interrupted || is_settled(run)) return;
  climb_last(run, beyond);
  if (run.interrupted || is_settled(run)) return;
  if (find_missing_roots(run, unsettled_paths(run)) && is_settled(run)) return;
  climb_to_clusters(run);
  if (!run.interrupted && !is_settled(run)) fail_unsettled(run);
}

/// Paths that failed, and those whose ends are told without a proof, unless they were followed in all digits.
PathSet unproved_paths(const Run& run) {
  PathSet paths = unsettled_paths(run);
  for (const auto& [path, root] : run.ledger.roots()) {
    if (!root.point.simple && !root.is_exact) paths.insert(path);
  }
  for (const std::uint64_t path : run.in_all_digits) paths.erase(path);
  return paths;
}

PathSet paths_at_infinity(const Run& run) {
  PathSet paths;
  for (std::uint64_t path = 0; path < run.ledger.records().size(); ++path) {
    if (run.ledger.records()[path].verdict == PathVerdict::at_infinity) paths.insert(path);
  }
  return paths;
}

/// The ends do not add up to what exact algebra counts: one that is told without a proof is none, and nothing tells which. Where there are
/// fewer ends than roots a path that is said to end at infinity may have jumped on its way, and a root of size 1e34 is there as far as
/// double tells.
void climb_from_contradiction(Run& run) {
  const auto& finer = run.setting.trackers.finer;
  const bool is_counted = run.bounds.ring.verdict == QuotientRing::Verdict::finite;
  if (finer.empty() || !is_counted || are_as_counted(run)) return;
  for (const auto& tracker : finer) {
    climb_while_it_helps(run, *tracker, unproved_paths(run), [] { return true; });
    if (run.interrupted || is_settled(run)) return;
  }
  if (!lacks_ends(run)) return;
  climb_while_it_helps(run, *finer.front(), paths_at_infinity(run), [] { return false; });
}

/// Simple roots as near to each other as 1e-45 pass for a multiple one in double-double.
void part_uncounted(Run& run, const Tracker& tracker) {
  auto clusters = clusters_in(run);
  std::erase_if(clusters, [&](const auto& cluster) {
    return is_counted_exactly(run, run.ledger.roots().at(cluster.first), cluster.second.size());
  });
  climb_to_simple_roots(run, clusters, [&](const PathSet& paths) {
    climb_beyond_double_double(run, tracker, paths);
  });
}

}  // namespace

void settle_doubts(Run& run) {
  if (settle_by_isolation(run)) return;
  settle_ends(run);
  // As many simple roots may be proved now as there are.
  if (settle_by_isolation(run)) return;
  if (!run.interrupted && !is_settled(run)) look_beside_sets(run);
  if (!run.interrupted && !is_settled(run)) resolve_blurred_sets(run);
  // More digits may have shown a simple root where others end.
  if (!run.interrupted && !is_settled(run)) fail_unsettled(run);
}

void climb_at_last(Run& run) {
  const auto& finer = run.setting.trackers.finer;
  if (finer.empty() || run.interrupted || is_settled(run)) return;
  climb_from_contradiction(run);
  if (run.interrupted || is_settled(run)) return;
  part_uncounted(run, *finer.front());
  fail_unsettled(run);
}

}  // namespace moivre
