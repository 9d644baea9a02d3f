// SPDX-License-Identifier: MIT
// What are all isolated roots of the closure polynomials, and do closures form sets? Blocks solved,
// roots checked on all equations.
//
//   as many equations as unknowns    block after block (stages.h)
//   more                             likewise, every root checked on all; where the solved ones
//                                    have a set of roots that the spare ones may cut, random
//                                    combinations of all are solved instead (square_up.h)
//   fewer                            no closure is isolated: a pose that moves is looked for
//                                    (moving_pose.h), unless a part that is determined closes in
//                                    complex numbers only
// Edges: equations that contradict each other have no roots, and are not solved.
#pragma once

#include "closure_search.h"

namespace moivre {

/// Fills solutions, stages, paths and the rest of the account.
void find_roots(ClosureSearch& search);

/// Adds the unknowns and degrees of a part to those of the whole.
void append(const SystemFacts& part, SystemFacts& whole);

}  // namespace moivre
