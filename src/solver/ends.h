// SPDX-License-Identifier: MIT
// What does the end of a path say? Its verdict is entered in the ledger; a finite end must first prove a root of the system.
//
//   simple       a root is proved there, where that is asked for; else Newton's method on the system as given contracts
//   singular     sheets meet, and the endgame has told how many: a root as accurate as the endgame found it
//   otherwise    it shows no root in this precision: the path has failed
//
// A proof decides what Newton's method in double cannot: an end of which it says nothing may be proved simple, and a root that it
// takes for simple is not where no proof is to be had.
// J is singular along a curve of roots, but as rounded it may pass for a simple root's; the slices of dimension.h decide.
#pragma once

#include "run.h"

namespace moivre {

/// What one more following of the path, or of the rest of its way, took.
void count_following(Run& run, std::uint64_t path, const PathEnd& end);

/// Enters the verdict on a path; a finite end waits for refine_ends(). A path that was cut short has no entry, nor has one that waits
/// for more effort.
void take_end(Run& run, std::uint64_t path, PathEnd&& end);

/// The tolerance of a simple root.
double simple_tolerance(const Refined& root);

/// Enters all finite ends that wait, on all threads. Where only regular ends are sought, what is not proved waits for more effort.
void refine_ends(Run& run);

}  // namespace moivre
