// SPDX-License-Identifier: MIT
// What is the result of a run? Paths that end at one point are one solution, and every path is
// counted once.
//
//   tracked = finite + at_infinity + failed + not_needed;  finite = sum of multiplicities +
//   on_positive_dimensional
//
// Ends on a set of positive dimension are counted, and are no solutions.
#pragma once

#include "run.h"

namespace moivre {

/// The solution of the paths `group`, all of them finite ends at one point, of cycles of these
/// winding numbers.
Solution solution_of(const Run& run, PathGroups::Group group, const std::vector<int>& winding);

/// Fills counts, solutions, failures, work, the verdict and its sentence. Roots that are told are
/// then no longer in the table. Throws Interrupted, the table as it was.
void close_account(Run& run, SolveResult& result);

/// What was found later leaves the result in doubt, whatever its account says.
void put_in_doubt(SolveResult& result, std::string why);

}  // namespace moivre
