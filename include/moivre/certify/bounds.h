// SPDX-License-Identifier: MIT
// How many isolated roots can there be at most? The Bezout number, from the degrees of the exact
// system.
//
//   isolated roots, counted with multiplicity  <=  d_1 d_2 ... d_n        (n polynomials in n
//                                                  unknowns)
//
// If as many certified roots as a proved bound are pairwise distinct, they are all isolated roots,
// and all are simple. The degrees are those of the exact coefficients; no small coefficient counts
// as zero. A constant polynomial correctly makes the bound 0:
// if it is zero no root is isolated, otherwise there is none. Not supported: sharper bounds;
// systems that are not square.
#pragma once

#include <cstdint>
#include <optional>

#include "moivre/polynomial/system.h"

namespace moivre {

/// nullopt when it leaves 64 bits. Throws std::invalid_argument when F is not square.
std::optional<std::uint64_t> bezout_bound(const System& f);

}  // namespace moivre
