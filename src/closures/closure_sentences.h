// SPDX-License-Identifier: MIT
// How does a search for closures say in English what it found, and what it left out? Every sentence
// of its results stands here.
//
// Which case holds, and its numbers, are decided where they are known; the words alone are chosen
// here. A clause begins with "; " and follows a message.
// Lengths are in the file's unit, by its name; empty: it has none.
// Edges: what refuses a mechanism is told where it is looked at, by InvalidInput.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "moivre/closures/closures.h"

namespace moivre {

/// How a search went, where no number says more.
enum class ClosureVerdict {
  interrupted,
  image_lost,
  roots_lost,
  not_confirmed,
  paths_failed,
  moves_without_driver,
  moves_with_drivers_held,
  moves_as_rounded,
  partly_complex,
  no_closure,
  decided
};
std::string closure_message(ClosureVerdict verdict);
/// Whether closures form a set is undecided after Newton-Raphson from so many `starts`;
/// is_drawn_alone: it stands at the drawn pose, which closes.
std::string undecided_set_message(bool has_isolated, bool is_drawn_alone, int starts);
std::string undecided_closures_message(std::uint64_t closures);
std::string complex_closures_message(std::uint64_t closures);
std::string fitted_closures_message(std::uint64_t closures, double fit, const std::string& unit);

/// fit: that would take the nearest pose; nullopt: it is too far away for one.
std::string nearest_pose_clause(double misfit, const std::string& misses_most,
                                const std::string& unit, std::optional<double> fit);
/// Poses besides the closures that miss by `most` or less.
std::string near_poses_clause(std::size_t poses, double most, const std::string& unit, double fit);
std::string play_clause(const std::string& closure, double play);

// Starts of the blocks.
std::string why_blocks_are_solved_in_order();
std::string why_blocks_have_counts();
std::string start_from_general_member(std::size_t poses, const std::string& mechanism_class);
/// Of a stage, by the bodies that it places.
std::string group_of_bodies(const std::vector<std::string>& bodies);
std::string group_with_equations_combined(const std::string& group);

// What was left out.
LeftOut closures_beyond_limits_left_out(std::uint64_t closures, const Joint& joint);
LeftOut complex_sets_left_out();
/// most: closures of the whole that are all listed.
LeftOut combined_closures_left_out(std::uint64_t most);
LeftOut excluded_roots_left_out(std::uint64_t roots, const std::string& reason);
LeftOut spare_equations_left_out(std::size_t spare, std::size_t equations);
LeftOut lone_equations_left_out(std::size_t equations);
LeftOut blocks_above_rejected_left_out(std::uint64_t roots);
LeftOut shared_paths_left_out(std::uint64_t solves);
LeftOut paths_of_formulas_left_out(std::uint64_t solves);
LeftOut doubtful_paths_left_out_by_contradiction(std::size_t paths);
LeftOut doubtful_paths_left_out_by_bound(std::size_t paths, std::uint64_t poses,
                                         const std::string& mechanism_class);

/// How an idle joint is held: at an angle (in radians, told in `unit`), or where a body has no
/// other place.
std::string held_at_angle(double angle, const std::string& unit, const std::string& body);
std::string held_in_one_turn();

}  // namespace moivre
