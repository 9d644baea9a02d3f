// SPDX-License-Identifier: MIT
// Which n equations in n unknowns keep every isolated root of N > n equations? n random combinations of them.
//
// Equations in order of falling degree; to each of the first n a random combination of the others is added, so that no
// degree grows. For almost every choice the isolated roots of all N equations are isolated roots of the n (Bertini), and
// the n have no set of roots of positive dimension but those of the N; the other roots fail an equation and are dropped.
// Source: [SommeseWampler05, ch. 13], randomization.
#pragma once

#include <cstdint>

#include "moivre/polynomial/system.h"

namespace moivre {

/// f: N >= n polynomials in n unknowns. The combinations, rational, come from `seed`.
System squared_up(const System& f, std::uint64_t seed);

}  // namespace moivre
