// SPDX-License-Identifier: MIT
// Which roots does the text have, and which are there only since sqrt(2) and pi were rounded?
//
//   F      with 40 digits of each such number
//   F~     System::nudged: each changed by 1e-38 to 1e-37 of itself, at least 100 times as much as
//          rounding did
// A root x of F holds where F~ has a root x~ of the same kind (real or not, as often) with
//   |x - x~| <= 1e-6 of its room: of its distance to the next root of F, of the largest imaginary
//   part if it is not real, of max(1, |x|)
// so a root that the rounding has made does not hold, such as x = 1e40 of
// (sqrt(2)^2 - 2)*x^2 + x = 1, nor do two that it has parted. What is no root of both is in doubt,
// and nothing is proved complete then. Roots that hold are known to |x - x~|.
// A regular root whose condition is beyond double does not hold either: where the equations of a
// text depend on each other, those of F and F~ may have a point in common.
// Edges: nothing is proved of the numbers meant; it is F of which proofs tell.
// Not supported: families, start points.
// Private to the module.
#pragma once

#include "moivre/solver/solve.h"

namespace moivre {

/// `nudged`: what solve() found of F~.
void keep_what_rounding_leaves(const SolveResult& nudged, SolveResult& result);

}  // namespace moivre
