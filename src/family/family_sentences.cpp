// SPDX-License-Identifier: MIT
// The English of a family's results.
#include "family_sentences.h"

#include <string_view>

#include "moivre/expression/counted.h"

namespace moivre {
namespace {

constexpr std::string_view kAsTheFileSays = "the file says, unproved: ";

std::string told_strays(int strays) {
  return std::to_string(strays) +
         " times a random root was not among those that loops lead to: the family is reducible, or "
         "loops have lost roots";
}

std::string told_loops(int loops) { return std::to_string(loops) + " loops"; }

}  // namespace

std::string standing_of_solved(SolvedStanding standing) {
  switch (standing) {
    case SolvedStanding::undecided:
      return "not every path was decided: roots may be missing";
    case SolvedStanding::has_irregular_roots:
      return "every member has roots that are not regular, which are not part of the family";
    case SolvedStanding::shown:
      return "shown: every path was decided and every root is certified";
    case SolvedStanding::not_all_certified:
      return "open: not every root is certified";
    case SolvedStanding::decided:
      return "every path was decided";
  }
  return {};
}

std::string standing_by_bound(BoundKind bound) {
  return "proved: the roots are as many as the " + name_in_results(bound) + " allows";
}

std::string standing_by_bound_of_loops(BoundKind bound, int strays) {
  const std::string proved =
      "proved: as many certified roots as the " + name_in_results(bound) + " allows";
  return strays > 0 ? proved + "; " + told_strays(strays) : proved;
}

std::string standing_with_strays(int strays) { return told_strays(strays) + "; there may be more"; }

std::string standing_of_interrupted(int loops) {
  return "interrupted after " + told_loops(loops) + ": there may be more roots";
}

std::string standing_of_cut_loops(int loops) {
  return told_loops(loops) +
         ", until a limit of loops or roots ended them: there may be more roots";
}

std::string standing_without_trace_test(int loops, std::uint64_t lost) {
  const std::string why =
      lost == 0 ? "" : ", since " + counted(lost, "point") + " of the curve could not be followed";
  return told_loops(loops) + ", the last ones without a new root; no trace test" + why;
}

std::string standing_by_trace_test(bool holds, std::uint64_t points) {
  const std::string tested = counted(points, "point") + " of the curve";
  return holds ? "shown: the trace test holds (" + tested +
                     "), and no root of another component was met by chance"
               : "the trace test fails (" + tested + "): roots are missing";
}

std::string standing_refuted_by_algebra(std::uint64_t counted_roots) {
  return "exact algebra counts " + counted(counted_roots, "root") +
         " with multiplicities: roots are missing, or multiple";
}

std::string standing_as_a_claim(std::string standing) {
  if (!standing.empty() && !standing.starts_with(kAsTheFileSays)) {
    standing.insert(0, kAsTheFileSays);
  }
  return standing;
}

std::string standing_of_file_refuted(std::uint64_t roots, std::uint64_t counted_roots) {
  return "the file has " + counted(roots, "root") + ", and exact algebra counts " +
         std::to_string(counted_roots) + " of a generic member: roots are missing";
}

std::string start_from_generic_roots(std::size_t roots) {
  return "the " + counted(roots, "root") + " of a generic member";
}

std::string start_from_given_roots(std::size_t roots) {
  return "the " + counted(roots, "root") + " that were given";
}

LeftOut lost_start_points_left_out(std::size_t points) {
  return {counted(points, "start point"),
          "no regular root of the system at p0, or its path broke off"};
}

}  // namespace moivre
