// SPDX-License-Identifier: MIT
// The ways to follow paths: all, those that wait with more effort, some again in smaller steps or
// with more digits.
#include "tracking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "clusters.h"
#include "completeness.h"
#include "ends.h"
#include "missing_roots.h"
#include "observed_paths.h"

namespace moivre {
namespace {

void report_progress(const Run& run) {
  if (!run.setting.options.progress) return;
  Progress progress;
  progress.total = run.setting.prepared.plan->paths;
  progress.done = run.table.tracked() + run.ends.size();
  progress.finite = run.table.count(PathVerdict::finite) + run.ends.size();
  run.setting.options.progress(progress);
}

// So many paths are followed before others begin; more where they may wait for one another: as many
// as fit into this memory with the points that each has kept.
constexpr std::uint64_t kPathsTogether = 4096;
constexpr std::uint64_t kBytesOfWaiting = std::uint64_t{64} << 20;

std::uint64_t paths_together(const PathProblem& problem) {
  if (problem.endgame.only_regular) return kPathsTogether;
  const auto points = static_cast<std::uint64_t>(problem.endgame.ends.samples) + 5;
  const std::uint64_t coordinates = problem.plan.last().coordinates();
  return std::max(kPathsTogether, kBytesOfWaiting / (points * coordinates * sizeof(Complex)));
}

/// Verdicts go to `sink`, but for those that the run's end cut short; what is finite is refined.
void follow(Run& run, const PathProblem& problem, const PathList& paths, int tolerance_level,
            const EndSink& sink, Unproved unproved = Unproved::fails) {
  const Setting& setting = run.setting;
  std::uint64_t ended = 0;
  const EndSink sink_unless_cancelled = [&](std::uint64_t path, PathEnd&& end) {
    if (end.failure == Failure::cancelled) return;
    ++ended;
    sink(path, std::move(end));
  };
  bool has_memory = true;
  const std::uint64_t together = paths_together(problem);
  for (std::uint64_t first = 0; first < paths.count && has_memory && !setting.stop;
       first += together) {
    const PathList block{std::min(together, paths.count - first),
                         [&](std::uint64_t k) { return paths.path_of(first + k); },
                         paths.endgame_starts};
    has_memory = observe_paths(problem, block, tolerance_level, setting.threads,
                               sink_unless_cancelled, setting.stop, setting.options.observations);
    // Ends that wait to be refined take much more memory than roots.
    judge_ends(run, unproved);
  }
  Observations* const observations = setting.options.observations;
  if (observations != nullptr && !setting.stop) observations->lists_are_done();
  // What was refined after a stop is not proved.
  if (ended < paths.count || setting.stop) run.interrupted = true;
  if (!has_memory) run.interrupted = run.out_of_memory = true;
}

void follow(Run& run, const PathProblem& problem, const PathSet& paths, int tolerance_level,
            const EndSink& sink, Unproved unproved = Unproved::fails,
            const EndgameStarts* endgame_starts = nullptr) {
  const std::vector<std::uint64_t> list(paths.begin(), paths.end());
  follow(run, problem, {list.size(), [&](std::uint64_t k) { return list[k]; }, endgame_starts},
         tolerance_level, sink, unproved);
}

/// Takes every end as its verdict comes in.
EndSink taking_ends(Run& run) {
  return [&run](std::uint64_t path, PathEnd&& end) {
    take_end(run, path, std::move(end));
    report_progress(run);
  };
}

/// The paths that came to no verdict.
PathSet raise_with(Run& run, const Tracker& tracker, PathPrecision precision, Taken taken,
                   const PathSet& paths) {
  PathSet undecided;
  if (paths.empty() || run.interrupted) return undecided;
  const Setting& setting = run.setting;
  EndgameOptions endgame = setting.endgame;
  endgame.goes_straight = true;
  endgame.only_regular = taken == Taken::regular_ends;
  const PathProblem problem{*setting.prepared.plan, tracker, endgame};
  follow(
      run, problem, paths, 0,
      [&](std::uint64_t path, PathEnd&& end) {
        if (end.status == PathStatus::failed) {
          count_following(run, path, end);
          undecided.insert(path);
          return;
        }
        take_end(run, path, std::move(end));
        run.table.set_precision(path, precision);
      },
      taken == Taken::regular_ends ? Unproved::agrees : Unproved::fails);
  return undecided;
}

// Of what waits so many are followed on before it is asked whether the others are needed, then
// twice as many.
constexpr std::size_t kFirstPart = 256;

/// Whether what waits leads to no further root. Not asked where every path is to be followed.
bool needs_no_more_effort(Run& run) {
  if (settle_by_bound(run)) return true;
  if (!is_longest_algebra_worth_it(run)) return false;
  if (are_ends_as_many_as_bound(run)) part_clusters_in_more_bits(run);
  give_missing_roots(run);
  return settle_by_bound(run);
}

/// What waits, by the size of the affine point where it does: most of what grows goes to infinity.
/// First comes what has been at an end that it did not prove.
std::vector<std::uint64_t> waiting_by_size(const Run& run) {
  std::vector<std::pair<double, std::uint64_t>> by_size;
  by_size.reserve(run.waiting.size());
  for (const auto& [path, endgame_start] : run.waiting) {
    const Point x = where_it_waits(run, endgame_start);
    const double size = x.empty() ? 0 : max_norm(x);
    by_size.emplace_back(std::isnan(size) ? std::numeric_limits<double>::infinity() : size, path);
  }
  std::sort(by_size.begin(), by_size.end());
  std::vector<std::uint64_t> paths;
  paths.reserve(by_size.size());
  for (const auto& [size, path] : by_size) paths.push_back(path);
  return paths;
}

/// Takes these out of run.waiting and follows them on from where each stands, else from its start.
void follow_on(Run& run, const PathProblem& problem, std::span<const std::uint64_t> paths) {
  EndgameStarts starts;
  PathSet stand_at_endgame_starts;
  PathSet begin_again;
  for (const std::uint64_t path : paths) {
    auto node = run.waiting.extract(path);
    (node.mapped().x.empty() ? begin_again : stand_at_endgame_starts).insert(path);
    starts.insert(std::move(node));
  }
  const int tolerance_level = run.setting.options.tolerance_level;
  follow(run, problem, stand_at_endgame_starts, tolerance_level, taking_ends(run), Unproved::fails,
         &starts);
  follow(run, problem, begin_again, tolerance_level, taking_ends(run));
}

}  // namespace

void track_to_ends(Run& run) {
  track_all(run);
  for (const Effort effort : {Effort::few_steps, Effort::all_steps}) {
    if (effort <= first_effort(run.setting)) continue;
    if (run.waiting.empty() || run.interrupted) return;
    if (!run.setting.options.every_path && needs_no_more_effort(run)) return;
    track_waiting(run, effort);
  }
}

void track_all(Run& run) {
  const Setting& setting = run.setting;
  run.effort = first_effort(setting);
  const PathProblem problem{*setting.prepared.plan, setting.tracker(),
                            endgame_for(setting, run.effort)};
  const PathList all{setting.prepared.plan->paths, [](std::uint64_t k) { return k; }};
  const Unproved unproved = run.effort == Effort::regular_ends ? Unproved::waits : Unproved::fails;
  follow(run, problem, all, setting.options.tolerance_level, taking_ends(run), unproved);
  run.effort = Effort::all_steps;
}

void track_waiting(Run& run, Effort effort) {
  const Setting& setting = run.setting;
  run.effort = effort;
  const PathProblem problem{*setting.prepared.plan, setting.tracker(),
                            endgame_for(setting, effort)};
  const std::vector<std::uint64_t> waiting = waiting_by_size(run);
  std::span<const std::uint64_t> left(waiting);
  for (std::size_t part = kFirstPart; !left.empty() && !run.interrupted; part *= 2) {
    const bool is_asked_again = !setting.options.every_path && is_longest_algebra_worth_it(run);
    const std::size_t count = is_asked_again ? std::min(part, left.size()) : left.size();
    follow_on(run, problem, left.first(count));
    left = left.subspan(count);
    if (!left.empty() && needs_no_more_effort(run)) break;
  }
  run.effort = Effort::all_steps;
}

void track_again(Run& run, const PathSet& paths, int tolerance_level) {
  if (run.setting.falls_back(tolerance_level)) {
    for (const std::uint64_t path : paths) run.table.set_handed_over(path);
  }
  follow(run, run.setting.problem(tolerance_level), paths, tolerance_level,
         [&](std::uint64_t path, PathEnd&& end) { take_end(run, path, std::move(end)); });
}

PathSet raise_together(Run& run, const PathSet& paths, Taken taken) {
  const Trackers& trackers = run.setting.trackers;
  return trackers.fine_lanes
             ? raise_with(run, *trackers.fine_lanes, PathPrecision::double_double, taken, paths)
             : PathSet{};
}

void raise_precision(Run& run, const PathSet& paths, Taken taken) {
  const Trackers& trackers = run.setting.trackers;
  if (!trackers.fine) return;
  raise_with(run, *trackers.fine, PathPrecision::double_double, taken,
             trackers.fine_lanes ? raise_together(run, paths, taken) : paths);
}

void raise_beyond_double_double(Run& run, const Tracker& tracker, const PathSet& paths) {
  raise_with(run, tracker, PathPrecision::multiprecision, Taken::regular_ends, paths);
  const bool is_last = &tracker == run.setting.trackers.finer.back().get();
  if (is_last) run.in_all_digits.insert(paths.begin(), paths.end());
}

}  // namespace moivre
