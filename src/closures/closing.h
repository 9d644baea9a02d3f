// SPDX-License-Identifier: MIT
// Does a root of some of the closure equations satisfy all of them, or do they all but close there?
//
// Where there are more equations than unknowns, a root of as many as there are unknowns leaves the others at rounding where they
// hold. A residual above rounding and still small may be either the root's own error, which Gauss-Newton on all equations takes
// away, or a pose that closes to nine digits only, where least squares stops.
#pragma once

#include "moivre/formulation/formulation.h"

namespace moivre {

/// residual_of_root behind a few steps of Gauss-Newton, in complex numbers, on every equation.
double residual_when_polished(const Formulation& formulation, Point root);

}  // namespace moivre
