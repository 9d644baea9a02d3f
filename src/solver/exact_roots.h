// SPDX-License-Identifier: MIT
// Which roots are known exactly, and how often does the system have them? What exact algebra can count, no path has to.
//
//   x in the doubles of a point, F(x) = 0 exactly, isolated and not simple: multiplicity by polynomial/local_multiplicity.h
//
// Looked for at 0 and at the ends that are no simple roots. Every path but the simple roots' own has to end at one of these, where
// they and the simple roots are as many as a bound allows (completeness.h), however badly its end was seen.
// Edges: roots of doubles that are not exact, sqrt(2) or 1/3, are none of these. Private to the module.
#pragma once

#include "run.h"

namespace moivre {

/// 0: x is no root of F, or nothing can be said.
std::uint64_t exact_multiplicity(const System& f, const Point& x);

/// Of multiplicity 2 at least; none where nothing is to be proved.
std::vector<ExactRoot> exact_roots(Run& run);

}  // namespace moivre
