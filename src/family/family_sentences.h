// SPDX-License-Identifier: MIT
// How is it said in English what is known of a family's roots, and of its members? Every sentence
// of results stands here.
//
// Which case holds, and its numbers, are decided where they are known; the words alone are chosen
// here.
// Edges: rules that a caller or a file broke are told where they are looked at, by InvalidInput or
// with the place in the file.
#pragma once

#include <cstdint>
#include <string>

#include "moivre/family/family.h"

namespace moivre {

/// The standing of a family whose generic member was solved, where no bound is met.
enum class SolvedStanding { undecided, has_irregular_roots, shown, not_all_certified, decided };
std::string standing_of_solved(SolvedStanding standing);
/// The same where the roots are as many as a bound.
std::string standing_by_bound(BoundKind bound);

// The standing of a family whose roots loops found.
/// strays: roots that chance found and no loop leads to.
std::string standing_by_bound_of_loops(BoundKind bound, int strays);
std::string standing_with_strays(int strays);
std::string standing_of_interrupted(int loops);
std::string standing_of_cut_loops(int loops);
/// lost: points of the curve that could not be followed for a trace test; 0: none was begun.
std::string standing_without_trace_test(int loops, std::uint64_t lost);
std::string standing_by_trace_test(bool holds, std::uint64_t points);
std::string standing_refuted_by_algebra(std::uint64_t counted_roots);

// The standing of a family that was read from a file.
/// The file's own words, told as such; what is told so already, and nothing, stay.
std::string standing_as_a_claim(std::string standing);
std::string standing_of_file_refuted(std::uint64_t roots, std::uint64_t counted_roots);

/// Why a member is solved from these roots.
std::string start_from_generic_roots(std::size_t roots);
std::string start_from_given_roots(std::size_t roots);
LeftOut lost_start_points_left_out(std::size_t points);

}  // namespace moivre
