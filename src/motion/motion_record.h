// SPDX-License-Identifier: MIT
// What does the result say of the tracks? Branches with ids, events that they share, a row for
// every checkpoint.
//
// Tracks that begin at `from` keep their order and so the ids of the closures there; later ones
// follow by where they begin. Those that begin at one event, where their times differ by rounding,
// stand in the order in which they were found.
// One event stands for all branches that begin or end there; the best known time and pose of it is
// kept.
// A closure without a branch, a branch without a closure, and a branch that does not lead back are
// failures, a sentence each.
#pragma once

#include "solved_checkpoint.h"

namespace moivre {

/// A result of nothing yet: times and seed.
MotionResult empty_result(const MotionOptions& options, const MotionTimes& times);

/// Drops tracks of a moment that end where others begin or end: a motion that begins at a dead
/// point has a closure there, and what lives are the branches that leave it.
void drop_moments(MotionRun& run);

/// Sorts the tracks into the order of their ids.
void order_tracks(MotionRun& run);

/// Enters a branch for every track, in their order, and the events, by time.
void enter_branches(const MotionRun& run, MotionResult& result);

/// Keeps these events, in this order; every branch that is left ends at one of them, or at none.
void keep_events(const std::vector<std::size_t>& kept, MotionResult& result);
/// Puts the events in the order of their times.
void order_events(MotionResult& result);

/// Enters the checkpoint's row, and what does not agree there; after enter_branches(), which gives
/// the ids.
void enter_checkpoint(const MotionRun& run, const SolvedCheckpoint& solved, MotionResult& result);

/// Enters the branches that do not lead back to where they were found.
void enter_unverified(const MotionRun& run, MotionResult& result);

/// Enters the branches that end at a dead point alone.
void enter_unmet(const MotionRun& run, MotionResult& result);

}  // namespace moivre
