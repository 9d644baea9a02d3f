// SPDX-License-Identifier: MIT
// Is there no root near this point? Proved by exact Taylor sums: a polynomial too far from zero to
// reach it.
//
//   G(x + h) = sum_b C_b h^b;   |C_0| > sum_{b != 0} |C_b| a^|b|   ==>   G has no zero with |h_j|
//                               <= a for all j
//
// G: each equation of F, and that combination y F, y a row of J(x)^{-1}, whose Newton step is
// longest: it sees how far away the root is in ill-conditioned systems. C_b is exact in rationals
// up to an order that grows with the multiplicity claimed; of higher orders the sizes of the terms
// are taken. Sums are rounded upward. Not proved says nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// True: no x' with |x'_j - x_j| <= radius for all j is a root of F, which may have any number of
/// equations.
/// multiplicity: of the root that is claimed; it changes the work, never what is proved.
bool has_no_root_within(const System& f, const Point& x, double radius,
                        std::uint64_t multiplicity = 1);
/// The same of a point that double does not hold.
bool has_no_root_near(const System& f, const std::vector<Coefficient>& x, double radius,
                      std::uint64_t multiplicity = 1);

}  // namespace moivre
