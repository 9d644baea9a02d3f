// SPDX-License-Identifier: MIT
// What does a result on the bases of powers say of the powers? Everything once for each of the
// paths that coincide.
//
//   F_i = c_i B_i^{e_i};  H = prod of the sheets of t B + (1 - t) G: `sheets` paths of F lie on
//                         each path of B, of which one is followed
//
// Path k of B stands for the paths sheets k, ..., sheets k + sheets - 1 of F. Counts of paths,
// multiplicities and bounds are multiplied;
// roots, certificates (one root, of that multiplicity) and the work done stay. Residuals are those
// of F.
// Lists by path (table, failures, windings) are left empty where they would have more than
// kMostListed entries.
// Private to the module.
#pragma once

#include "moivre/polynomial/powers.h"
#include "moivre/solver/solve.h"

namespace moivre {

inline constexpr std::uint64_t kMostListed = std::uint64_t{1} << 24;

/// Throws std::overflow_error when the number of paths leaves 64 bits.
void take_back_powers(const System& f, const PowerFree& bases, SolveResult& result);

}  // namespace moivre
