// SPDX-License-Identifier: MIT
// Do the linear equations hold no more unknowns than they are? Then each of these is one number,
// which is lifted from its digits modulo a prime (lifting.h): substituted one by one, n dense
// equations would multiply and divide n^3 integers as long as n.
//
// Edges: only where an eighth of the coefficients are not zero, real and exact, and the
// substitutions have made integers longer than a word: elsewhere these are short work.
// Private to the module.
#pragma once

#include "elimination_state.h"

namespace moivre::elimination {

bool has_long_block(const State& s);

/// Requires one. Changes nothing where the prime divides its determinant, or an equation of higher
/// degree would get a coefficient beyond the limit.
void substitute_block(State& s, const Limits& limits);

}  // namespace moivre::elimination
