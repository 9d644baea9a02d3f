// SPDX-License-Identifier: MIT
// How many roots does a place hold at most that is known approximately only? As many as its local
// ring has dimensions.
//
//   D_k as in local_multiplicity.h, of whatever root x* has |x* - x|_inf <= e; N_k: a bound, dim
//   D_k <= N_k for all of them an isolated root of multiplicity m has dim D_k <= m, one on a curve
//   exceeds every m at last
//
// The rows y^b F_i are known up to what moving x by e changes in F: to the first order in e by the
// coefficients themselves, to the second by the sizes of the terms. Columns that stay independent
// whatever this changes give the rank at least, and N_k. Every unit of length of y gives a bound,
// some a better one: of several the best is taken.
//
// Edges: where e hides the ring N_k is too large and says nothing. Not supported: more than a few
// hundred monomials.
// Source: [DaytonZeng05], and [BatesHauensteinPetersonSommese09] for the dimension from a bound on
// the multiplicity.
#pragma once

#include <cstdint>
#include <optional>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

struct RingBound {
  std::uint64_t dimension = 0;  ///< N_k for the largest k looked at
  bool is_isolated = false;     ///< N_k = N_{k-1}: the ring does not grow, as far as bounds show
};

/// f: any number of equations in n unknowns. x: n. error: absolute, in the maximum norm. nullopt:
/// too many monomials to say anything.
std::optional<RingBound> local_ring_near(const System& f, const Point& x, double error);

}  // namespace moivre
