// SPDX-License-Identifier: MIT
// How are many paths followed to their ends on all threads?
// Every thread has a session, a scratch and the endgames of the paths it has under way.
//
// A path that has walked one turn around t = 1 waits until all others of its thousands have come so
// far: those that lead to one another are the sheets of one cycle, and its samples are theirs
// (cycles.h). So a cycle of m sheets takes m turns, not m times m, on smaller circles, too. Where
// no path waits on some of its sheets, the last before these walks on through them for all.
//
// Results do not depend on the number of threads: a path's end depends on its number, its tolerance
// level and the paths that it is followed with. Memory: the endgames under way, those that wait,
// and what the sink keeps.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "cycles.h"
#include "moivre/endgame/endgame.h"
#include "moivre/solver/solve.h"
#include "moivre/start/start_plan.h"

namespace moivre {

/// The paths of a plan and who follows them.
struct PathProblem {
  const StartPlan& plan;
  const Tracker& tracker;
  const EndgameOptions& endgame;
};

/// Receives the verdict on a path; called by one thread at a time, in any order of paths.
using EndSink = std::function<void(std::uint64_t path, PathEnd&& end)>;

/// Paths at the starts of their endgames, by number.
using EndgameStarts = std::map<std::uint64_t, EndgameStart>;

/// The number of the next job of a list; none where there is no other. Thread-safe.
using JobDraw = std::function<std::optional<std::uint64_t>()>;

/// Few paths, which are not known to be hard: to wake other threads, or to tell other processes,
/// takes longer than to follow them.
bool are_few(std::uint64_t paths, int tolerance_level);

/// Which paths, and from where.
struct PathList {
  std::uint64_t count = 0;
  std::function<std::uint64_t(std::uint64_t)> path_of;  ///< the k-th, k < count
  const EndgameStarts* endgame_starts =
      nullptr;              ///< where they are taken up again; nullptr: they begin
  std::uint64_t known = 0;  ///< others of the list, which were followed before without waiting
  JobDraw draw = {};  ///< says which is next, and may leave some to others; empty: in their order
};

/// A path that has walked one turn.
struct WaitingPath {
  std::uint64_t path = 0;
  std::unique_ptr<Endgame> endgame;
};

/// Follows them on `threads` threads, at most all at once: they may wait for one another. Paths cut
/// short by `stop` end as Failure::cancelled; those not yet begun are not reported. False where
/// memory ran out: those under way on the thread that met it are not reported either. Calls
/// `when_they_wait`, where there is one, before the ends in which others have a part.
bool track_paths(const PathProblem& problem, const PathList& paths, int tolerance_level,
                 int threads, const EndSink& sink, const std::atomic<bool>& stop,
                 const std::function<void()>& when_they_wait = {});

/// The first part of it: as far as no other path has a part in what becomes of them. Adds those
/// that wait.
bool track_until_they_wait(const PathProblem& problem, const PathList& paths, int tolerance_level,
                           int threads, const EndSink& sink, const std::atomic<bool>& stop,
                           std::vector<WaitingPath>& waiting);

/// The chains among all that wait, which are put into the order of their paths. Each stands in one,
/// by its position.
std::vector<SheetChain> chains_among(std::vector<WaitingPath>& waiting);

/// The second part: those chains that are drawn, to their ends.
bool walk_cycles(const PathProblem& problem, std::vector<WaitingPath>& waiting,
                 const std::vector<SheetChain>& chains, const JobDraw& draw, int threads,
                 const EndSink& sink, const std::atomic<bool>& stop);

/// f(k) for k in [0, count) on `threads` threads; in order on the caller's thread when that is one.
void for_each_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& f);

}  // namespace moivre
