// SPDX-License-Identifier: MIT
// Which closures are there at a checkpoint, and which track is at each?
//
// A track is at the closure nearest to its pose, where that is the same pose. Two tracks at one
// closure are a conflict: one of them has left its branch. Half of the progress that is shown is
// for the checkpoints at first, half for the tracks.
#pragma once

#include <optional>
#include <utility>

#include "moivre/numeric/near_points.h"
#include "motion_run.h"

namespace moivre {

struct SolvedCheckpoint {
  double time = 0;
  ClosureResult closures;
  NearNumbers numbers;                               ///< of the closures
  std::vector<std::optional<std::size_t>> track_of;  ///< one a closure: index into the tracks
  /// Closures, complex ones too, those counted once that are as near to each other as rounding
  /// parts a double one.
  std::size_t distinct = 0;
  bool are_apart = true;  ///< no two are so near, and none is multiple
};

/// Without tracks.
SolvedCheckpoint solved_checkpoint(const Phi& phi, ClosureResult closures);

/// Index of the nearest closure that is the same pose as q.
std::optional<std::size_t> nearest_closure(const Phi& phi, const SolvedCheckpoint& solved,
                                           const Eigen::VectorXd& q);

/// Whether it is simple, and no other closure there is so near that rounding may have parted a
/// double one.
bool stands_alone(const Phi& phi, const SolvedCheckpoint& solved, std::size_t closure);

/// The checkpoints at `from` and at every checkpoint, ascending; fewer where the run was stopped.
std::vector<SolvedCheckpoint> solve_checkpoints(const MotionRun& run, const Tracker& tracker);

/// Between two checkpoints closures are solved so often where a joint's limits hide some.
inline constexpr int kFiner = 16;

/// Solves closures in between where a joint's limits hide some. True when there was such a place.
bool look_closer(MotionRun& run, const Tracker& tracker,
                 std::vector<SolvedCheckpoint>& checkpoints);

/// Solves closures at further times; the checkpoints stay ascending.
void add_checkpoints(MotionRun& run, const Tracker& tracker, const std::vector<double>& times,
                     std::vector<SolvedCheckpoint>& checkpoints);

/// Drops the checkpoints at which branches cross and closures are not all decided or not apart:
/// there a pose may move though the drivers stand (an arm's straight wrist), and paths come to no
/// isolated root, or to one that rounding parts. Closures are solved in the stretches on both
/// sides, and what is one to one there is so across the crossing, too. The first and the last
/// checkpoint stay.
/// Returns the times of those that were dropped.
std::vector<double> drop_crossings(const MotionRun& run,
                                   std::vector<SolvedCheckpoint>& checkpoints);

/// Sets solved.track_of. Two tracks that are at one closure are returned, the older first.
std::optional<std::pair<std::size_t, std::size_t>> match(const MotionRun& run,
                                                         SolvedCheckpoint& solved);

}  // namespace moivre
