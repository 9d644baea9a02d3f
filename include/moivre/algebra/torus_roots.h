// SPDX-License-Identifier: MIT
// Is there no root without zero coordinates? Shown by exact algebra where there are more equations
// than unknowns.
//
//   such a root is one of all x^b F_i and of all their combinations; a combination of one term
//   alone has none rows x^b F_i up to degree k, columns the monomials: does their span hold a unit
//   vector?
//
// If there is no such root, one is found for k large enough (Hilbert's Nullstellensatz). k grows
// until then. Ranks are taken modulo a prime of 61 bits, drawn from the numbers of F: the answer is
// wrong with probability about 1e-18.
//
// Edges: an equation of one term settles it at once, however many equations there are. Not
// supported: more than a few hundred monomials;
// false is the answer then, as it is where there is a root.
#pragma once

#include "moivre/polynomial/system.h"

namespace moivre {

/// f: any number of equations, none of them 0.
bool has_no_torus_root(const System& f);

}  // namespace moivre
