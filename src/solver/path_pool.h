// SPDX-License-Identifier: MIT
// How are many paths followed to their ends on all threads?
// Every thread has a session, a scratch and the endgames of the paths it has under way.
//
// A path that has walked one turn around t = 1 waits until all others of its thousands have come so far: those that lead to one
// another are the sheets of one cycle, and its samples are theirs (cycles.h). So a cycle of m sheets takes m turns, not m times m.
//
// Results do not depend on the number of threads: a path's journey depends on its number, its care and the paths that it is
// followed with. Memory: the endgames under way, those that wait, and what the sink keeps.
#pragma once

#include <cstdint>
#include <functional>
#include <map>

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

/// So many paths are followed before others begin: at most so many wait for one another.
inline constexpr std::uint64_t kPathsTogether = 4096;

/// Follows `count` paths, the k-th being path_of(k), on `threads` threads. Paths cut short by
/// `stop` end as Failure::cancelled; those not yet begun are not reported.
void track_paths(const PathProblem& problem, std::uint64_t count,
                 const std::function<std::uint64_t(std::uint64_t)>& path_of, int care, int threads,
                 const EndSink& sink, const std::atomic<bool>& stop);

/// Paths at their outposts, by number.
using Outposts = std::map<std::uint64_t, Outpost>;

/// Takes these paths up again, as track_paths() follows others.
void track_on(const PathProblem& problem, const Outposts& outposts, int care, int threads,
              const EndSink& sink, const std::atomic<bool>& stop);

/// The start point of the last stage from which `x` (homogeneous, an end point at t = 1) is reached: x is followed back to
/// t = 0. nullopt when the way back breaks off.
std::optional<Point> followed_back(const PathProblem& problem, const Point& x, int care,
                                   const std::atomic<bool>& stop);

/// f(k) for k in [0, count) on `threads` threads; in order on the caller's thread when that is one.
void for_each_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& f);

}  // namespace moivre
