// SPDX-License-Identifier: MIT
// What does the end of a path say? Its verdict is entered in the table; a finite end must first
// prove a root of the system.
//
//   simple       a root is proved there (certificates.h)
//   singular     sheets meet, and the endgame has told how many: a root as accurate as the endgame
//                found it
//   otherwise    it shows no root in this precision: who followed the path says what that means
#pragma once

#include "moivre/endgame/endgame.h"
#include "run.h"

namespace moivre {

/// The affine point from which the path is followed on; empty where that is its start.
Point where_it_waits(const Run& run, const EndgameStart& endgame_start);

/// What one more following of the path, or of the rest of its way, took.
void count_following(Run& run, std::uint64_t path, const PathEnd& end);

/// Enters the verdict on a path; a finite end waits for judge_ends(). A path that was cut short has
/// no entry, nor has one that waits for more effort.
void take_end(Run& run, std::uint64_t path, PathEnd&& end);

/// The simple root that is proved.
Root proved_root(Refiner& refiner, std::shared_ptr<const Certificate> proof);

/// The mean of sheets that circles have closed, relative to max(1, |x|_inf).
inline constexpr double kMeanIsKnownTo = 1e-10;

/// What becomes of a path whose end shows no root.
enum class Unproved {
  fails,
  waits,  ///< for more effort
  agrees  ///< with an end that circles have told, where it is the same point; else it fails: a path
          ///< that comes to a multiple root without a turn lands there as on a simple one
};

/// Enters all finite ends that wait, on all threads.
void judge_ends(Run& run, Unproved unproved);

}  // namespace moivre
