// SPDX-License-Identifier: MIT
// How does a motion say in English what it found, and what it did not? Every sentence of its
// results stands here.
//
// Which case holds, and its numbers, are decided where they are known; the words alone are chosen
// here. Times in seconds. Ids and names are those of the result.
// Edges: rules that a caller broke are told where they are looked at, by InvalidInput.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "moivre/motion/circuits.h"

namespace moivre {

/// How a motion went, as a whole.
enum class MotionVerdict { interrupted, followed, undecided, not_assembled };
std::string motion_message(MotionVerdict verdict);

/// The message of a branch that ended nowhere.
std::string followed_to_the_end();
/// The message of one that seems to end in the simple closure from which it sets out.
std::string not_followed_from_closure();

// Failures, of a branch or of the closures at one time.
std::string branch_failure(const std::string& branch, double time, const std::string& message);
std::string branch_without_closure(const std::string& branch, double time);
std::string branch_takes_another_way(const std::string& branch);
std::string branch_unmet_at_dead_point(const std::string& branch, double time);
std::string closure_on_no_branch(const std::string& closure, double time);
std::string closures_failure(double time, const std::string& message);
/// body: the first one of the sub-chain.
std::string sub_chain_failure(const std::string& body, const std::string& failure);

/// The message of a checkpoint whose closures and branches match.
std::string one_to_one(std::uint64_t closures, std::uint64_t branches);
/// The same, where of several sub-chains `listed` branches of the whole are there.
std::string one_to_one_in_sub_chains(std::uint64_t closures, std::uint64_t listed);

// Doubts about branches between checkpoints.
std::string pair_not_solved(double time);
std::string brief_closures_incomplete(double time);
std::string brief_meeting_not_found(double time);
/// times: that were solved in vain between the two.
std::string no_regular_time(std::uint64_t times, double from, double to);
/// unsolved: the first time at which closures were not solved, though an event lies beside it.
std::string events_without_end(std::uint64_t times, std::optional<double> unsolved);

/// Stretches in which pairs of closures cannot be followed.
struct SampledStretches {
  std::size_t count = 0;
  double from = 0;  ///< of the first one
  double to = 0;    ///< of the last one
  std::uint64_t checkpoints = 0;
};
LeftOut short_branches_left_out(const SampledStretches& sampled);
LeftOut touching_closures_left_out(double time);
LeftOut instants_left_out(std::uint64_t closures, double time);
LeftOut crossed_checkpoint_left_out(double time);
LeftOut hidden_branches_left_out();
LeftOut later_checkpoints_left_out();

/// A guess by its number, from 1.
std::string guess_failure(std::size_t guess, const std::string& newton_message);
LeftOut repeated_guess_left_out(std::size_t guess);
LeftOut closures_left_out_by_guesses();

/// most: branches of the whole that are all listed.
LeftOut combined_branches_left_out(std::size_t most);
LeftOut unreachable_branches_left_out(const std::vector<std::string>& branches,
                                      const std::vector<std::string>& asked_closures);

/// The closures to choose from, where one was asked for that is not there; `are_more` than these.
std::string known_closures(const std::vector<std::string>& ids, bool are_more);
/// of: the ids of each sub-chain's closure, for an example.
std::string names_in_sub_chains(const std::vector<std::string>& of);

/// What leaves circuits open.
enum class CircuitNote {
  turn_ends_in_other_poses,
  motion_incomplete,
  no_closures,
  drivers_move_together,
  more_than_one_turn,
  drivers_do_not_return,
  not_all_listed
};
std::string circuit_note(CircuitNote note);
std::string turning_driver_note(const std::string& driver);

}  // namespace moivre
