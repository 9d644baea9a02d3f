// SPDX-License-Identifier: MIT
// Which roots of the cleared equations are roots of what was typed? Those where no denominator is
// zero.
//
// A denominator is zero where its value is, to what the root's accuracy leaves of it. Exact algebra
// counts the roots of F and u d_1 d_2 ... - 1 in one unknown more, which are those off the
// denominators: the result is complete only if it has as many.
#pragma once

#include "moivre/solver/solve.h"

namespace moivre {

/// Takes the others out of the solutions of f and counts them.
void drop_on_denominators(const System& f, SolveResult& result);

}  // namespace moivre
