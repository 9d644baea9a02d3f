// SPDX-License-Identifier: MIT
// Which roots are known exactly, and how often does the system have them? What exact algebra can
// count, no path has to.
//
//   x of fractions, F(x) = 0 exactly, isolated and not simple: multiplicity by
//   algebra/local_multiplicity.h
//
// Candidates: 0; the ends that are no simple roots, as they are and rounded to the simplest
// fractions (numeric/simplest.h) within several errors; where paths have failed, what their last
// points round to. A wrong candidate costs a little time, no more:
// F vanishes there exactly or it is forgotten. Every path but the simple roots' own has to end at
// one of these, where they and the simple roots are as many as a bound allows (completeness.h),
// however badly its end was seen.
// Edges: roots that are no fractions, sqrt(2), are none of these, nor are those of long
// denominators, unless the quotient ring has told all that are multiple (missing_roots.h). Private
// to the module.
#pragma once

#include "run.h"

namespace moivre {

/// Which fractions x, known to `known_to` relative to max(1, |x|_inf), may have been: x as it is,
/// then the simplest ones within larger and larger errors of each coordinate, at last of the whole
/// point.
std::vector<std::vector<Coefficient>> fractions_near(const Point& x, double known_to);

/// Of multiplicity 2 at least; none where nothing is to be proved. Throws Interrupted.
std::vector<ExactRoot> exact_roots(Run& run);

/// Whether the end is one of these, which F has as often as paths end there.
bool is_counted_by(const std::vector<ExactRoot>& exact, const Root& end, std::size_t paths);

}  // namespace moivre
