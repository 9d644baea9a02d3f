// SPDX-License-Identifier: MIT
// Does a cheap local search find a closure that is not in the list? Then the list is not complete,
// whatever the paths say.
//
// Newton-Raphson from the drawn pose, from the guess, from random poses and from poses beside
// closures: a few starts, the same for the same seed. What it comes to is a contradiction where it
// is a regular pose, within the limits, and none of the closures.
// Nothing found proves nothing.
#pragma once

#include "closure_search.h"

namespace moivre {

/// Marks the closure that was drawn.
void mark_drawn(ClosureSearch& search);

/// Counts contradictions in `rootless`.
void look_for_witnesses(ClosureSearch& search);

}  // namespace moivre
