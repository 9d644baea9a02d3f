// SPDX-License-Identifier: MIT
// How does a member of a class that was solved before lead to another one? By the straight line of
// coefficients between them.
//
//   t F + (1 - t) G, both scaled for F;  paths from the roots of G
//
// F, G: square systems in the same unknowns, equation by equation of the same kind. The line has to
// avoid members with fewer roots, so G is complex, or its equations are multiplied by complex
// numbers.
// Source: [SommeseWampler05, ch. 7].
#pragma once

#include "moivre/solver/given_start.h"
#include "moivre/solver/solve.h"

namespace moivre {

/// choose_scaling(), and rows with their largest coefficient in [1, 2): a homotopy's equations are
/// to be near 1.
Scaling scaling_to(const System& member);

/// The roots in the units of the scaling, homogeneous.
std::vector<Point> scaled_roots(const std::vector<Point>& roots, const Scaling& scaling);

/// From the roots of g to those of f.
GivenStart start_from_member(const System& f, const System& g,
                             const std::vector<Point>& roots_of_g);

}  // namespace moivre
