// SPDX-License-Identifier: MIT
// Doubtful paths: found in the ledger, followed again, and counted as failed where nothing helps.
#include "doubts.h"

#include <algorithm>

#include "tracking.h"

namespace moivre {
namespace {

// A root's image under conjugation is known as well as the root; Newton's method takes it from there.
constexpr double kImageAccuracy = 1e-12;

/// Simple roots nearer to each other than double can tell pass for one singular root. One path to each such root is
/// followed in double-double: where it finds a regular end, so do the others.
void resolve_clusters(Run& run) {
  std::map<std::uint64_t, std::vector<std::uint64_t>> clusters;
  PathSet first;
  for (const auto& group : run.ledger.groups()) {
    const Root& root = run.ledger.roots().at(group.front());
    if (group.size() == 1 || root.point.simple || is_on_set(run, root)) continue;
    first.insert(group.front());
    clusters[group.front()] = group;
  }
  climb(run, first);
  PathSet others;
  for (const auto& [path, group] : clusters) {
    if (rung_of(run, path) == Rung::double_double) others.insert(group.begin() + 1, group.end());
  }
  climb(run, others);
}

PathSet paths_failed_by(const Run& run, Failure reason) {
  PathSet paths;
  for (const auto& [path, failure] : run.ledger.failures()) {
    if (failure.failure == reason) paths.insert(path);
  }
  return paths;
}

/// The image of a root is a root; one that no path found was lost by the path that leads to it. Counts those roots too.
PathSet paths_to_missing_conjugates(Run& run, int care) {
  PathSet paths;
  run.unsettled_conjugates = 0;
  const Setting& setting = run.setting;
  if (!is_real(setting.f)) return paths;
  Refiner refiner(setting.refiner_program);
  for (const Point& image : missing_conjugates(run.ledger)) {
    const Refined root = refiner.refine(image, kImageAccuracy);
    if (!root.simple) continue;
    ++run.unsettled_conjugates;
    const auto path = path_through(setting.problem(care), to_homogeneous(setting.prepared, root.x),
                                   care, setting.stop);
    if (path) paths.insert(*path);
  }
  return paths;
}

bool is_in_doubt(const Run& run, const std::vector<std::uint64_t>& group) {
  const auto is_simple = [&](std::uint64_t path) {
    return run.ledger.roots().at(path).point.simple;
  };
  if (std::all_of(group.begin(), group.end(), is_simple)) return group.size() > 1;
  const bool is_whole = group.size() > 1 && cycles(run.ledger, group);
  return !is_whole && !is_on_set(run, run.ledger.roots().at(group.front()));
}

PathSet doubtful_paths(Run& run, int care) {
  PathSet doubtful;
  for (const auto& [path, failure] : run.ledger.failures()) doubtful.insert(path);
  for (const auto& group : run.ledger.groups()) {
    if (is_in_doubt(run, group)) doubtful.insert(group.begin(), group.end());
  }
  doubtful.merge(paths_to_missing_conjugates(run, care));
  return doubtful;
}

void fail(Run& run, std::uint64_t path, Failure reason) {
  run.ledger.strike(path);
  run.ledger.enter_failure({path, reason, 1});
}

/// Two paths cannot end at one simple root: all but the first are lost. And one path alone cannot end
/// at an isolated root that is not simple: what it ends at is no root that this precision can show.
void fail_unsettled(Run& run) {
  for (const auto& group : run.ledger.groups()) {
    const Root& first = run.ledger.roots().at(group.front());
    if (group.size() == 1 && !first.point.simple && !is_on_set(run, first)) {
      fail(run, group.front(), Failure::precision);
      continue;
    }
    for (std::size_t k = 1; k < group.size(); ++k) {
      if (run.ledger.roots().at(group[k]).point.simple) fail(run, group[k], Failure::jumped);
    }
  }
  for (const std::uint64_t path :
       paths_to_missing_conjugates(run, run.setting.options.maximum_care)) {
    fail(run, path, Failure::jumped);
  }
}

}  // namespace

void settle_doubts(Run& run) {
  const SolveOptions& options = run.setting.options;
  resolve_clusters(run);
  for (int care = options.care + 1; care <= options.maximum_care && !run.interrupted; ++care) {
    const PathSet doubtful = doubtful_paths(run, care);
    if (doubtful.empty()) return;
    track_again(run, doubtful, care);
    if (care == options.care + 1) climb(run, paths_failed_by(run, Failure::precision));
  }
  if (run.interrupted) return;
  PathSet last = doubtful_paths(run, options.maximum_care + 1);
  // More digits save no steps: the caller's budget stands.
  for (const std::uint64_t path : paths_failed_by(run, Failure::step_limit)) last.erase(path);
  climb(run, last);
  if (!run.interrupted) fail_unsettled(run);
}

}  // namespace moivre
