// SPDX-License-Identifier: MIT
// Which simpler system has the same roots, each less often? The one without the exponents of
// equations that are powers.
//
//   F_i = c_i B_i^{e_i},  e_i as large as can be;  B: the system of the bases;  sheets = e_1 e_2
//                                                  ... e_n
//
// F and B have the same isolated roots, and a root's multiplicity in F is `sheets` times that in B:
// intersection numbers are additive in each equation. For the same reason F's total degree,
// multihomogeneous numbers and mixed volume are `sheets` times those of B. So the paths of F are
// those of B, each `sheets` times.
//
// Exact, in Gaussian integers: c_i takes what remains. A line modulo a prime tells at once what is
// no power. An equation is taken as it is where it is constant, of a degree above 4096, or where
// its base takes more than a few seconds, and where `sheets` would leave 64 bits.
// Not supported: factors of which only some are powers.
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

struct PowerFree {
  System system;                         ///< B, with F's groups
  std::vector<std::uint64_t> exponents;  ///< e_i >= 1
  std::uint64_t sheets = 1;
};

PowerFree power_free(const System& f);

}  // namespace moivre
