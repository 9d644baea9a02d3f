// SPDX-License-Identifier: MIT
// What does the end of a path say? Its verdict is entered in the ledger; a finite end must first
// prove a root of the system.
//
//   simple       a root is proved there (certificates.h)
//   singular     sheets meet, and the endgame has told how many: a root as accurate as the endgame
//                found it
//   otherwise    it shows no root in this precision: the path has failed
#pragma once

#include "run.h"

namespace moivre {

/// What one more following of the path, or of the rest of its way, took.
void count_following(Run& run, std::uint64_t path, const PathEnd& end);

/// Enters the verdict on a path; a finite end waits for judge_ends(). A path that was cut short has
/// no entry, nor has one that waits for more effort.
void take_end(Run& run, std::uint64_t path, PathEnd&& end);

/// The simple root that is proved.
Root proved_root(Refiner& refiner, std::shared_ptr<const Certificate> proof);

/// Enters all finite ends that wait, on all threads. Where only regular ends are sought, what is
/// not proved waits for more effort.
void judge_ends(Run& run);

}  // namespace moivre
