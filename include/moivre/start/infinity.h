// SPDX-License-Identifier: MIT
// Do the degrees already give the number of roots? They do unless a generic system with these
// supports has a root at infinity.
//
//   A_i with 0 added; T_i: its terms of degree d_i. Mixed volume = Bezout number, unless for some
//   J, a nonempty set of unknowns, the leading forms with terms in J alone have a common root whose
//   coordinates in J are not zero. For generic coefficients they have one exactly when vectors
//   drawn at random from the spans of the differences of their terms are linearly independent: k
//   polynomials in a torus meet when the supports of any l of them together have dimension l at
//   least.
//
// No mixed cell is looked for. The random vectors and their rank are those of a field of 2^61 - 1
// elements; a wrong answer has a chance below 1e-15. All 2^n sets J are tried, up to kMostUnknowns.
// Sources: [Bernstein75], theorem B; [SommeseWampler05, ch. 8].
#pragma once

#include <optional>
#include <vector>

#include "moivre/start/support.h"

namespace moivre {

inline constexpr std::size_t kMostUnknowns = 14;

/// Does a generic system with these supports have roots at infinity? Then its mixed volume, with 0
/// added, is below its Bezout number. nullopt: more than kMostUnknowns. Throws
/// std::invalid_argument unless there are as many supports as unknowns.
std::optional<bool> meets_infinity(const std::vector<Support>& supports);

}  // namespace moivre
