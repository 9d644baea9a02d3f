// SPDX-License-Identifier: MIT
// Which equations hold for the joints outside the cut? Polynomials in their tangents, one for each.
//
// The product of the rest of the loop, backwards, must lie in the cut's space W. Where there are more equations than unknowns,
// random combinations of them; roots that fail one are found out when they are read back.
#pragma once

#include "cut.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// The product of the tangents of bits that are set: t_k+1 for bit k.
Monomial multilinear(std::size_t bits);

/// Unknowns t1, t2, ...: the tangents s/c of cut.outside, in that order; none where all joints are inside.
System cut_equations(const Loop& loop, const Cut& cut, std::uint64_t seed);

}  // namespace moivre
