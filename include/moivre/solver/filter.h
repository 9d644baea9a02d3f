// SPDX-License-Identifier: MIT
// Which roots are wanted? Real ones, positive ones, those without a zero, those in a box; what is
// not wanted is counted.
//
// A root is kept or left out by its coordinates as they are told: real where Solution::real says
// so, zero where a coordinate is no larger than the root's accuracy. Where a bound of the box lies
// within the accuracy of a coordinate the root is kept.
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

  bool wants_all() const { return !real && !positive && !nonzero && box.empty(); }
};

/// Every broken rule as a sentence: unknowns that the system has not, ranges that are no numbers or
/// run backwards.
std::vector<std::string> broken_rules(const RootFilter& filter,
                                      const std::vector<std::string>& unknowns);

/// Takes the others out of the solutions and counts them in `filtered`. Throws InvalidInput with
/// every broken rule.
void keep_wanted(const RootFilter& filter, SolveResult& result);

}  // namespace moivre
