// SPDX-License-Identifier: MIT
// How does a solve say in English what it found, what is in doubt, and what it left out? Every
// sentence of its results stands here.
//
// Which case holds, and its numbers, are decided where they are known; the words alone are chosen
// here.
// Edges: what refuses a system or an option is told where it is looked at, by InvalidInput. Of
// these, what takes more than one statement stands at the end.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "moivre/polynomial/powers.h"
#include "moivre/polynomial/scale.h"
#include "moivre/solver/filter.h"
#include "moivre/solver/solve.h"

namespace moivre {

/// How a run went.
enum class SolveVerdict {
  decided,
  decided_or_not_needed,
  interrupted,
  interrupted_before_tracking,
  out_of_memory,
  paths_failed,
  conjugate_missing,
  eliminated,
  eliminated_beyond_double,
  contradictory,
  dependent,
  without_unknowns_holds,
  without_unknowns_contradictory,
  eliminated_by_combining
};
std::string solve_message(SolveVerdict verdict);

/// What puts a result in doubt.
enum class SolveDoubt {
  too_few_paths_at_a_root,
  paths_end_on_a_curve,
  family_may_lack_roots,
  witness_found_more,
  roots_hang_on_hidden_digits
};
std::string doubt_message(SolveDoubt doubt);

/// Of what exact algebra counts another number than was found.
enum class AlgebraCount {
  simple,
  with_multiplicities,
  different,
  different_of_the_file,
  off_denominators
};
std::string algebra_doubt(AlgebraCount of, std::uint64_t count, std::uint64_t found);
std::string certified_root_of_start_missing(StartSource start);
std::string other_equations_undecided(std::size_t roots);

// Starts.
std::string why_given_start_has_no_counts();
std::string why_count_is_too_large();
std::string start_from_roots_of_member(std::size_t roots);

// What was left out before paths were followed.
LeftOut certificates_not_built_left_out();
LeftOut scaling_left_out(const Scaling& scaling);
/// Paths in either case.
LeftOut elimination_left_out(std::uint64_t without_it, std::uint64_t with_it);
LeftOut isotropic_pairs_left_out(std::size_t pairs, std::uint64_t paths,
                                 std::uint64_t in_unknowns_of_file);
LeftOut exponents_left_out(const PowerFree& bases);

// What was left out of a square system's result.
LeftOut paths_as_rounded_left_out(std::uint64_t paths);
/// bound: that is met; nullopt: exact algebra counts no more.
LeftOut paths_not_needed_left_out(std::uint64_t paths, std::optional<BoundKind> bound);
/// paths: of that start; some of them failed.
LeftOut failed_start_left_out(StartSource start, const PathCounts& paths);
LeftOut roots_on_denominators_left_out(std::uint64_t roots);
LeftOut roots_that_may_be_none_left_out(std::uint64_t roots);
LeftOut unwanted_roots_left_out(const RootFilter& filter, std::uint64_t roots);
/// hidden: of the roots, those that their digits do not tell from the boundary.
LeftOut roots_off_condition_left_out(const std::string& condition, std::uint64_t roots,
                                     std::uint64_t hidden);

// What was left out of the digits that were asked for.
LeftOut digits_of_rounded_left_out(int last_digit);
LeftOut digits_not_guaranteed_left_out(int digits, std::uint64_t roots);
LeftOut digits_interrupted_left_out(int digits, std::uint64_t roots);

// What was left out where a system was made square.
/// excess: roots of the combinations that fail an equation of the file.
LeftOut combined_equations_left_out(std::size_t equations, std::size_t unknowns,
                                    std::uint64_t excess);
/// in_all: roots of the file with their multiplicities; nullopt: not counted.
LeftOut multiplicities_left_out(std::optional<std::uint64_t> in_all);
LeftOut combined_certificates_left_out();
LeftOut cut_sets_left_out(std::size_t added_equations);
LeftOut patches_left_out();

/// A clause on a name that is the names of two unknowns side by side.
std::string meant_product_clause(const std::string& left, const std::string& right);
/// Bytes.
std::string paths_beyond_memory(std::uint64_t paths, double needed, double memory);

}  // namespace moivre
