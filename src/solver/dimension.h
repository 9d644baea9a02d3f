// SPDX-License-Identifier: MIT
// Is a singular root isolated, or does it lie on a curve of roots?
//
// A random hyperplane through x is moved by a small step, and Gauss-Newton looks for a root near x
// on the moved plane: F(y) = 0, l(y) = l(x) + step. On a curve (or more) there is one, and its residual is
// rounding; beside an isolated root of multiplicity m the residual stays near step^m. Three planes of
// five have to agree.
// Not supported: isolated roots of multiplicity above 12, whose residual is rounding as well.
// Source: [SommeseWampler05, ch. 13], local dimension by slicing.
#pragma once

#include "refine.h"

namespace moivre {

/// F: as given. x: a singular root of it, n coordinates.
bool lies_on_positive_dimensional_set(const System& f, const Point& x, std::uint64_t seed);

}  // namespace moivre
