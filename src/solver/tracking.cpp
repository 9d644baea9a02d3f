// SPDX-License-Identifier: MIT
// The ways to follow paths: all, those that wait with more effort, some again with more care, some again with more digits.
#include "tracking.h"

#include <algorithm>
#include <utility>

#include "ends.h"

namespace moivre {
namespace {

void report_progress(const Run& run) {
  if (!run.setting.options.progress) return;
  Progress progress;
  progress.total = run.setting.prepared.plan->paths;
  progress.done = run.ledger.tracked() + run.ends.size();
  progress.finite = run.ledger.count(PathVerdict::finite) + run.ends.size();
  run.setting.options.progress(progress);
}

/// Verdicts go to `sink`, but for those that the run's end cut short; what is finite is refined.
void track_these(Run& run, const PathProblem& problem, const PathSet& paths, int care,
                 const EndSink& sink) {
  const std::vector<std::uint64_t> list(paths.begin(), paths.end());
  const EndSink sink_unless_cancelled = [&](std::uint64_t path, PathEnd&& end) {
    if (end.failure == Failure::cancelled) {
      run.interrupted = true;
    } else {
      sink(path, std::move(end));
    }
  };
  track_paths(
      problem, list.size(), [&](std::uint64_t k) { return list[k]; }, care, run.setting.threads,
      sink_unless_cancelled, run.setting.stop);
  refine_ends(run);
}

/// The paths that came to no verdict, and those of them that ran out of steps.
struct Left {
  PathSet undecided;
  PathSet out_of_steps;
};

Left climb_with(Run& run, const Tracker& tracker, Rung rung, Taken taken, const PathSet& paths) {
  Left left;
  if (paths.empty() || run.interrupted) return left;
  const Setting& setting = run.setting;
  EndgameOptions endgame = setting.endgame;
  endgame.goes_straight = true;
  endgame.only_regular = taken == Taken::regular_ends;
  const PathProblem problem{*setting.prepared.plan, tracker, endgame};
  track_these(run, problem, paths, 0, [&](std::uint64_t path, PathEnd&& end) {
    if (end.status == PathStatus::failed) {
      count_following(run, path, end);
      left.undecided.insert(path);
      if (end.failure == Failure::step_limit) left.out_of_steps.insert(path);
      return;
    }
    take_end(run, path, std::move(end));
    run.ledger.set_rung(path, rung);
  });
  return left;
}

}  // namespace

void track_all(Run& run) {
  const Setting& setting = run.setting;
  run.effort = first_effort(setting);
  const PathProblem problem{*setting.prepared.plan, setting.tracker(),
                            endgame_for(setting, run.effort)};
  const std::uint64_t total = setting.prepared.plan->paths;
  std::uint64_t followed = 0;
  const EndSink sink = [&](std::uint64_t path, PathEnd&& end) {
    ++followed;
    take_end(run, path, std::move(end));
    report_progress(run);
  };
  for (std::uint64_t first = 0; first < total && !setting.stop; first += kPathsTogether) {
    track_paths(
        problem, std::min(kPathsTogether, total - first),
        [first](std::uint64_t k) { return first + k; }, setting.options.care, setting.threads, sink,
        setting.stop);
    // Ends that wait to be refined take much more memory than roots.
    refine_ends(run);
  }
  if (followed < total) run.interrupted = true;
  run.effort = Effort::all_steps;
}

void track_waiting(Run& run, Effort effort) {
  const Setting& setting = run.setting;
  run.effort = effort;
  const PathProblem problem{*setting.prepared.plan, setting.tracker(),
                            endgame_for(setting, effort)};
  Outposts waiting = std::exchange(run.waiting, {});
  PathSet from_start;
  for (const auto& [path, outpost] : waiting) {
    if (outpost.x.empty()) from_start.insert(path);
  }
  std::erase_if(waiting, [](const auto& path) { return path.second.x.empty(); });
  const EndSink sink = [&](std::uint64_t path, PathEnd&& end) {
    take_end(run, path, std::move(end));
    report_progress(run);
  };
  track_on(problem, waiting, setting.options.care, setting.threads, sink, setting.stop);
  track_these(run, problem, from_start, setting.options.care, sink);
  if (setting.stop) run.interrupted = true;
  run.effort = Effort::all_steps;
}

void track_again(Run& run, const PathSet& paths, int care) {
  if (run.setting.falls_back(care)) {
    for (const std::uint64_t path : paths) run.ledger.set_handed_over(path);
  }
  track_these(run, run.setting.problem(care), paths, care,
              [&](std::uint64_t path, PathEnd&& end) { take_end(run, path, std::move(end)); });
}

PathSet climb_together(Run& run, const PathSet& paths, Taken taken) {
  const Trackers& trackers = run.setting.trackers;
  return trackers.fine_own
             ? climb_with(run, *trackers.fine_own, Rung::double_double, taken, paths).undecided
             : PathSet{};
}

void climb(Run& run, const PathSet& paths, Taken taken) {
  const Trackers& trackers = run.setting.trackers;
  if (!trackers.fine) return;
  climb_with(run, *trackers.fine, Rung::double_double, taken,
             trackers.fine_own ? climb_together(run, paths, taken) : paths);
}

PathSet climb_beyond_double_double(Run& run, const Tracker& tracker, const PathSet& paths) {
  return climb_with(run, tracker, Rung::multiprecision, Taken::regular_ends, paths).out_of_steps;
}

}  // namespace moivre
