// SPDX-License-Identifier: MIT
// What is the multiplicity of a root that is known exactly? Linear algebra on its local ring, no
// tracking and no rounding.
//
//   y = x - root;  D_k: functionals on the polynomials in y of degree k at most that vanish on y^b
//                  F_i, |b| < k, cut off behind k
//   dim D_k = number of monomials of degree <= k - rank of the rows y^b F_i
//
// dim D_k grows with k until it is constant. It is then the multiplicity of the isolated root. At a
// root that is not isolated it grows forever, on a curve by the same number at last. Ranks are
// taken modulo a prime of 61 bits, drawn from the numbers of F, so that a multiplicity is wrong
// with probability about 1e-18.
//
// Not supported: more than a few hundred monomials; what is known then is dim D_k for the largest k
// within them.
// Source: Macaulay's inverse systems, [DaytonZeng05].
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

struct LocalRing {
  /// Of D_k for the largest k looked at: an isolated root has no smaller multiplicity.
  std::uint64_t dimension = 0;
  bool is_isolated = false;  ///< dim D_k stands still: `dimension` is the multiplicity
  /// The last two steps of k added equally many functionals, fewer than k. No graded ring can grow
  /// faster then [Gotzmann78], and one without relations of higher degree goes on so forever: a
  /// curve passes through x.
  bool grows_steadily = false;
};

/// f: any number of equations in n unknowns. x: n, exact. nullopt: x is no root, or nothing can be
/// said.
std::optional<LocalRing> local_ring(const System& f, const std::vector<Coefficient>& x);

/// f: any number of equations in n unknowns. x: n, exact. nullopt: x is no root, or not isolated,
/// or nothing can be said.
std::optional<std::uint64_t> local_multiplicity(const System& f, const std::vector<Coefficient>& x);

}  // namespace moivre
