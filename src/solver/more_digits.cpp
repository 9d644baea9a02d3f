// SPDX-License-Identifier: MIT
// Which paths go, who goes ahead, and how long.
#include "more_digits.h"

#include <algorithm>
#include <iterator>

#include "certificates.h"
#include "completeness.h"
#include "judge.h"
#include "settle.h"
#include "tracking.h"

namespace moivre {
namespace {

// So many paths go ahead in more digits than double-double.
constexpr std::size_t kFirstAhead = 2;

/// One path of each cluster goes ahead to a regular end.
PathSet first_of(const PathGroups& clusters) {
  PathSet first;
  for (const PathGroups::Group cluster : clusters) first.insert(cluster.front());
  return first;
}

/// Where it has found a simple root, so do the others.
PathSet others_of(const Run& run, const PathGroups& clusters) {
  PathSet others;
  for (const PathGroups::Group cluster : clusters) {
    const auto root = run.table.roots().find(cluster.front());
    if (root == run.table.roots().end() || !root->second.point.simple) continue;
    others.insert(std::next(cluster.begin()), cluster.end());
  }
  return others;
}

PathSet paths_failed_by(const Run& run, Failure reason) {
  PathSet paths;
  for (const auto& [path, failure] : run.table.failures()) {
    if (failure.failure == reason) paths.insert(path);
  }
  return paths;
}

PathSet paths_in_doubt_but_for(const Run& run, const PathSet& others) {
  PathSet paths = judge(run).in_doubt;
  for (const std::uint64_t path : others) paths.erase(path);
  return paths;
}

/// Those that more digits may help.
PathSet unsettled_paths(const Run& run) {
  return paths_in_doubt_but_for(run, paths_failed_by(run, Failure::step_limit));
}

bool has_come_to_a_simple_root(const Run& run, std::uint64_t path) {
  const auto root = run.table.roots().find(path);
  return root != run.table.roots().end() && root->second.point.simple &&
         run.table.precision(path) == PathPrecision::multiprecision;
}

bool has_helped(const Run& run, const PathSet& ahead) {
  return std::any_of(ahead.begin(), ahead.end(),
                     [&](auto path) { return has_come_to_a_simple_root(run, path); });
}

/// Paths that are open, and those whose ends are told without a proof, unless they were followed in
/// all digits.
PathSet unproved_paths(const Run& run) {
  PathSet paths = unsettled_paths(run);
  for (const auto& [path, root] : run.table.roots()) {
    if (!root.point.simple && !root.is_exact) paths.insert(path);
  }
  for (const std::uint64_t path : run.in_all_digits) paths.erase(path);
  return paths;
}

/// Where all roots are isolated, and fewer are proved than there are: ends of one path each without
/// a proof.
PathSet unproved_ends_alone(Run& run) {
  PathSet ends;
  if (run.bounds.ring.verdict != QuotientRing::Verdict::finite || !is_root_missing(run))
    return ends;
  for (const auto& [group, ground] : judge(run).roots) {
    if (group.size() == 1 && ground != Ground::proved) ends.insert(group.front());
  }
  return ends;
}

PathSet paths_at_infinity(const Run& run) {
  PathSet paths;
  for (std::uint64_t path = 0; path < run.table.records().size(); ++path) {
    if (run.table.records()[path].verdict == PathVerdict::at_infinity) paths.insert(path);
  }
  return paths;
}

}  // namespace

void part_in_double_double(Run& run) {
  const PathGroups clusters = clusters_at(run);
  raise_precision(run, first_of(clusters), Taken::regular_ends);
  raise_precision(run, others_of(run, clusters), Taken::regular_ends);
}

void raise_failed_paths(Run& run) {
  run.in_double_double = raise_together(run, paths_failed_by(run, Failure::precision));
}

void follow_in_smaller_steps(Run& run) {
  const SolveOptions& options = run.setting.options;
  if (options.tolerance_level >= options.maximum_tolerance_level) return;
  const PathSet paths = paths_in_doubt_but_for(run, run.in_double_double);
  if (paths.empty()) return;
  track_again(run, paths, options.maximum_tolerance_level);
  if (run.setting.trackers.fine_lanes) return;
  raise_precision(run, paths_failed_by(run, Failure::precision));
}

void raise_to_double_double(Run& run) {
  PathSet& raised = run.in_double_double;
  while (!run.interrupted) {
    PathSet last = unsettled_paths(run);
    last.merge(unproved_ends_alone(run));
    for (const std::uint64_t path : raised) last.erase(path);
    if (last.empty()) return;
    raise_precision(run, last);
    raised.merge(last);
  }
}

void raise_while_it_helps(Run& run, const Tracker& tracker, const PathSet& paths,
                          const std::function<bool()>& goes_on) {
  std::size_t together = kFirstAhead;
  for (auto next = paths.begin(); next != paths.end() && !run.interrupted; together *= 2) {
    PathSet ahead;
    while (next != paths.end() && ahead.size() < together) ahead.insert(*next++);
    raise_beyond_double_double(run, tracker, ahead);
    if (has_helped(run, ahead) ? is_settled(run) : !goes_on()) return;
  }
}

void raise_to_more_digits(Run& run) {
  for (const auto& tracker : run.setting.trackers.finer) {
    raise_while_it_helps(run, *tracker, unsettled_paths(run), [&] { return is_root_missing(run); });
    if (run.interrupted || is_settled(run)) return;
  }
}

void raise_after_contradiction(Run& run) {
  const auto& finer = run.setting.trackers.finer;
  const bool is_counted = run.bounds.ring.verdict == QuotientRing::Verdict::finite;
  if (finer.empty() || !is_counted || are_as_counted(run)) return;
  for (const auto& tracker : finer) {
    raise_while_it_helps(run, *tracker, unproved_paths(run), [] { return true; });
    if (run.interrupted || is_settled(run)) return;
  }
  if (!lacks_ends(run)) return;
  raise_while_it_helps(run, *finer.front(), paths_at_infinity(run), [] { return false; });
}

}  // namespace moivre
