// SPDX-License-Identifier: MIT
// Which paths are followed, by whom and how carefully? All once, and on where they wait; those in
// doubt again, and in more digits.
//
// Every verdict goes to ends.h. A path that is followed again loses its entry in the table only
// when the new verdict is there: an interruption leaves no path without one. What `stop` cuts short
// marks the run as interrupted.
#pragma once

#include "run.h"

namespace moivre {

/// Follows all, and with more effort those that wait, unless the others have met a bound: then they
/// lead to no other root. That is not asked where every path is to be followed.
void track_to_ends(Run& run);

/// Follows every path of the start system, with no more effort than may be enough, and reports the
/// progress.
void track_all(Run& run);

/// Follows on what waits, from where each stands, else from its start, and reports the progress.
/// Where that takes longer than exact algebra may, the smallest points go first, and after each
/// part, twice as large as the one before, it is asked whether the rest is needed.
void track_waiting(Run& run, Effort effort);

/// Follows these at that tolerance level: by the fallback, where there is one.
void track_again(Run& run, const PathSet& paths, int tolerance_level);

/// Which ends in double-double are verdicts? Without circles none but regular ones are found.
enum class Taken { all_ends, regular_ends };

/// Follows these in double-double: together where the tracker can, and what that leaves one by one.
/// Where there is no verdict either, the path's entry stays as it is. Does nothing where no path
/// may be followed beyond double.
void raise_precision(Run& run, const PathSet& paths, Taken taken = Taken::all_ends);

/// Follows these together in double-double. Returns the paths that it does not decide; does
/// nothing, and returns none, where neither tracker has lanes for that.
PathSet raise_together(Run& run, const PathSet& paths, Taken taken = Taken::all_ends);

/// Follows these to regular ends by a tracker of more digits than double-double. A path that finds
/// none keeps its entry.
void raise_beyond_double_double(Run& run, const Tracker& tracker, const PathSet& paths);

}  // namespace moivre
