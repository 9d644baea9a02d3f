// SPDX-License-Identifier: MIT
// The English of a solve.
#include "solver_sentences.h"

#include <cstdio>

#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"

namespace moivre {
namespace {

std::string told_asked_for(std::uint64_t roots) {
  return "as asked for: " + counted(roots, "root is", "roots are") + " not told";
}

std::string told_digits(int digits, std::uint64_t roots) {
  return std::to_string(digits) + " digits of " + counted(roots, "root");
}

std::string told_filter(const RootFilter& filter) {
  std::vector<std::string> words;
  if (filter.real) words.emplace_back("real");
  if (filter.positive) words.emplace_back("positive");
  if (filter.nonzero) words.emplace_back("without a zero");
  if (!filter.box.empty()) words.emplace_back("in the box");
  return joined(words, ", ");
}

/// Of the equations that are powers.
std::string told_exponents(const PowerFree& bases) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < bases.exponents.size(); ++i) {
    if (bases.exponents[i] == 1) continue;
    words.push_back("equation " + std::to_string(i + 1) + ": " +
                    std::to_string(bases.exponents[i]));
  }
  return joined(words, ", ");
}

}  // namespace

std::string solve_message(SolveVerdict verdict) {
  switch (verdict) {
    case SolveVerdict::decided:
      return "every path was decided";
    case SolveVerdict::decided_or_not_needed:
      return "every path was decided or not needed";
    case SolveVerdict::interrupted:
      return "interrupted: what is finished is reported";
    case SolveVerdict::interrupted_before_tracking:
      return "interrupted: no path was followed";
    case SolveVerdict::out_of_memory:
      return "memory ran out: what is finished is reported";
    case SolveVerdict::paths_failed:
      return "some paths failed";
    case SolveVerdict::conjugate_missing:
      return "a root's conjugate is missing among the roots";
    case SolveVerdict::eliminated:
      return "every unknown was eliminated: one root";
    case SolveVerdict::eliminated_beyond_double:
      return "every unknown was eliminated: one root, beyond the range of double";
    case SolveVerdict::contradictory:
      return "the equations contradict each other: no root";
    case SolveVerdict::dependent:
      return "the equations depend on each other: every root lies on a set of positive dimension, "
             "none is isolated";
    case SolveVerdict::without_unknowns_holds:
      return "the equations have no unknowns, and hold: one root, the empty point";
    case SolveVerdict::without_unknowns_contradictory:
      return "the equations have no unknowns, and contradict each other: no root";
    case SolveVerdict::eliminated_by_combining:
      return "every unknown was eliminated: the root of the combinations is none of the file";
  }
  return {};
}

std::string doubt_message(SolveDoubt doubt) {
  switch (doubt) {
    case SolveDoubt::too_few_paths_at_a_root:
      return "fewer paths end at a multiple root than it has to have";
    case SolveDoubt::paths_end_on_a_curve:
      return "exact algebra tells that no root lies on a curve, paths end as on one";
    case SolveDoubt::family_may_lack_roots:
      return "the family that the paths start from may lack roots, and so may this member of it";
    case SolveDoubt::witness_found_more:
      return "the witness found roots that are missing here";
    case SolveDoubt::roots_hang_on_hidden_digits:
      return "numbers that are no fractions (sqrt(2), pi) are taken with 40 digits, and which "
             "roots there are hangs on the digits behind them";
  }
  return {};
}

std::string algebra_doubt(AlgebraCount of, std::uint64_t count, std::uint64_t found) {
  const std::string counts = "exact algebra counts ";
  const std::string those = ", those found are " + std::to_string(found);
  switch (of) {
    case AlgebraCount::simple:
      return counts + counted(count, "simple root") + those;
    case AlgebraCount::with_multiplicities:
      return counts + counted(count, "root") + " with their multiplicities, those found count " +
             std::to_string(found);
    case AlgebraCount::different:
      return counts + counted(count, "different root") + those;
    case AlgebraCount::different_of_the_file:
      return counts + counted(count, "different root") + " of the file's equations" + those;
    case AlgebraCount::off_denominators:
      return counts + counted(count, "root") + " where no denominator is zero" + those;
  }
  return {};
}

std::string certified_root_of_start_missing(StartSource start) {
  return "a certified root of the " + to_string(start) +
         " start is missing among those of --start polyhedral";
}

std::string other_equations_undecided(std::size_t roots) {
  return "whether the file's other equations vanish at " + counted(roots, "root") +
         " is not decided";
}

std::string why_given_start_has_no_counts() { return "the start is given"; }

std::string why_count_is_too_large() { return "beyond 64 bits"; }

std::string start_from_roots_of_member(std::size_t roots) {
  return "the " + counted(roots, "root") + " of a generic member";
}

LeftOut certificates_not_built_left_out() {
  return {"certificates beyond double",
          "this program was built without them (MOIVRE_WITH_CERTIFY)"};
}

LeftOut scaling_left_out(const Scaling& scaling) {
  return {"scaled: " + to_text(scaling),
          "coefficients far from 1 would hide roots from the tracker's tolerances"};
}

LeftOut elimination_left_out(std::uint64_t without_it, std::uint64_t with_it) {
  return {"elimination of linear equations", "without it there are " + counted(without_it, "path") +
                                                 ", with it " + std::to_string(with_it)};
}

LeftOut isotropic_pairs_left_out(std::size_t pairs, std::uint64_t paths,
                                 std::uint64_t in_unknowns_of_file) {
  return {counted(pairs, "pair") + " of unknowns as x + iy and x - iy",
          "there are " + counted(paths, "path") + " so, and " +
              std::to_string(in_unknowns_of_file) + " in the file's unknowns"};
}

LeftOut exponents_left_out(const PowerFree& bases) {
  return {"exponents of equations (" + told_exponents(bases) + ")",
          "the bases have the same roots; of " + counted(bases.sheets, "path") +
              " that coincide, one is followed"};
}

LeftOut paths_as_rounded_left_out(std::uint64_t paths) {
  return {"what the file's digits do not tell",
          counted(paths, "path ends", "paths end") +
              " at infinity for coefficients that differ from the file's by less than half a unit "
              "of the last digit"};
}

LeftOut paths_not_needed_left_out(std::uint64_t paths, std::optional<BoundKind> bound) {
  const std::string why =
      bound ? "the certified roots are as many as the " + name_in_results(*bound)
            : "the roots and their multiplicities are as many as exact algebra counts";
  return {counted(paths, "path") + " that were not needed",
          why + (paths == 1 ? ": it leads to no other" : ": they lead to no other")};
}

LeftOut failed_start_left_out(StartSource start, const PathCounts& paths) {
  return {"the " + to_string(start) + " start",
          std::to_string(paths.failed) + " of its " + counted(paths.tracked, "path") +
              " were undecided; the result is from --start polyhedral"};
}

LeftOut roots_on_denominators_left_out(std::uint64_t roots) {
  return {"roots where a denominator is zero",
          counted(roots, "root") + " of the equations without their denominators"};
}

LeftOut roots_that_may_be_none_left_out(std::uint64_t roots) {
  return {counted(roots, "root") + " that may be none",
          "sqrt(2), pi and the like are taken with 40 digits, and the digits behind them decide"};
}

LeftOut unwanted_roots_left_out(const RootFilter& filter, std::uint64_t roots) {
  return {"roots that are not " + told_filter(filter), told_asked_for(roots)};
}

LeftOut roots_off_condition_left_out(const std::string& condition, std::uint64_t roots,
                                     std::uint64_t hidden) {
  std::string why = told_asked_for(roots);
  if (hidden > 0) {
    why += ", " + std::to_string(hidden) + " of them on its boundary as far as digits tell";
  }
  return {"roots that do not meet " + condition, why};
}

LeftOut digits_of_rounded_left_out(int last_digit) {
  return {"digits behind the " + std::to_string(last_digit) + "th",
          "sqrt(2), pi and the like are taken with 40 digits"};
}

LeftOut digits_not_guaranteed_left_out(int digits, std::uint64_t roots) {
  return {told_digits(digits, roots),
          "Newton's method does not converge quadratically there, as at every singular root, or "
          "leads to another root, or double does not tell the root from another one; no digit "
          "could be guaranteed"};
}

LeftOut digits_interrupted_left_out(int digits, std::uint64_t roots) {
  return {told_digits(digits, roots), "the run was interrupted before"};
}

LeftOut combined_equations_left_out(std::size_t equations, std::size_t unknowns,
                                    std::uint64_t excess) {
  return {counted(equations, "equation") + " squared up to " + std::to_string(unknowns),
          counted(excess, "root of the combinations fails", "roots of the combinations fail") +
              " an equation of the file"};
}

LeftOut multiplicities_left_out(std::optional<std::uint64_t> in_all) {
  std::string why = "those told are the combinations', which may be larger";
  if (in_all) {
    why += "; exact algebra counts " + counted(*in_all, "root") +
           " of the file with their multiplicities";
  }
  return {"multiplicities of the file's equations", why};
}

LeftOut combined_certificates_left_out() {
  return {"certificates",
          "a proved root of the combinations need not be a root of the file's equations"};
}

LeftOut cut_sets_left_out(std::size_t added_equations) {
  return {"cut by " + counted(added_equations, "equation"),
          "asked for by --slice: the roots are witness points of sets of dimension " +
              std::to_string(added_equations)};
}

LeftOut patches_left_out() {
  return {"a patch for each homogeneous group",
          "roots are told with one coordinate of each group equal to 1"};
}

std::string meant_product_clause(const std::string& left, const std::string& right) {
  return "; `" + left + right + "` is one name: a product is written `" + left + '*' + right + '`';
}

std::string paths_beyond_memory(std::uint64_t paths, double needed, double memory) {
  constexpr double kGigabyte = 1e9;
  char sizes[80];
  std::snprintf(sizes, sizeof sizes, " take %.3g GB at least, and there are %.3g GB",
                needed / kGigabyte, memory / kGigabyte);
  return counted(paths, "path") + sizes;
}

}  // namespace moivre
