// SPDX-License-Identifier: MIT
// Which combinations of equations have a lower degree? Gaussian elimination on the monomials of the
// highest degree, degree by degree: where highest parts depend on each other, one of the equations
// becomes their combination.
//
// Edges: 0 = 0 is a dependent equation, c = 0 a contradiction; a combination whose integers become
// longer than allowed is left. Private to the module.
#pragma once

#include "elimination_state.h"

namespace moivre::elimination {

void combine(State& s, const Limits& limits);

}  // namespace moivre::elimination
