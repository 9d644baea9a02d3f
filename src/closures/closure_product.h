// SPDX-License-Identifier: MIT
// What are the closures of a mechanism whose sub-chains do not depend on each other? Those of each,
// solved once, and all choices of one.
//
//   counts     complex and real multiply; filtered: real ones but those within the limits of every
//              sub-chain; rejected add up
//   closures   one of each sub-chain, verified by Newton-Raphson on Phi of the whole
//   paths, stages, work and time add up: paths of a closure are numbered by those of its
//   sub-chains, the first one's slowest
// Edges: where a sub-chain moves, has no closure, was left undecided or closes within
// Mechanism::fit only, nothing is done here, and the mechanism is solved as a whole, whose verdict
// says why.
#pragma once

#include "closure_search.h"

namespace moivre {

/// Fills what find_roots and find_poses fill; false, and nothing changed, where the mechanism is to
/// be solved as a whole.
bool solve_apart(ClosureSearch& search);

}  // namespace moivre
