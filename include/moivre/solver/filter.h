// SPDX-License-Identifier: MIT
// Which roots are wanted? Real ones, positive ones, those without a zero, those in a box, those
// that meet conditions; what is not wanted is counted.
//
// A root is kept or left out by its coordinates as they are told: real where Solution::real says
// so, zero where a coordinate is no larger than the root's accuracy. Where a bound of the box lies
// within the accuracy of a coordinate the root is kept.
// A condition p > 0 is judged by what p can be within the accuracy of a real root. Where it can be
// above zero and below, the root lies on the boundary as far as its digits tell: p > 0 leaves it
// out, p >= 0 keeps it, and both are said (SolveResult::left_out, Solution::on_boundary).
// A filter changes no count of paths and no completeness: all roots were looked for, and `filtered`
// of them are not told.
#pragma once

#include <string>
#include <vector>

#include "moivre/solver/solve.h"

namespace moivre {

/// from <= x_j <= to, of a real root.
struct WantedRange {
  std::string unknown;
  double from = 0;
  double to = 0;
};

struct RootFilter {
  bool real = false;
  bool positive = false;              ///< real, and every coordinate above zero
  bool nonzero = false;               ///< no coordinate is zero
  std::vector<WantedRange> box = {};  ///< real, and within every range
  /// Real, and every one holds; in the unknowns of the system that is solved.
  std::vector<Condition> conditions = {};
};

/// Every broken rule as a sentence: unknowns that the system has not, ranges that are no numbers or
/// run backwards, conditions in other unknowns.
std::vector<std::string> broken_rules(const RootFilter& filter,
                                      const std::vector<std::string>& unknowns);

/// Takes the others out of the solutions and counts them in `filtered`. Throws InvalidInput with
/// every broken rule.
void keep_wanted(const RootFilter& filter, SolveResult& result);

}  // namespace moivre
