// SPDX-License-Identifier: MIT
// What are all isolated roots of one member of a family? They are found by as many paths as a
// generic member has roots.
//
//   H(x, t) = F(x; (1 - t) p* + t p),  t from 0 to 1, from the roots at p*
//
// p* is a random complex member, so that no path meets another before t = 1. Ends are judged,
// refined, certified and counted as in solve(). If p is special, roots meet or go to infinity, and
// the counts show it. Rows and unknowns are scaled for the system at p.
//
// Completeness:
//   proved   as many roots are certified as the bound allows that was met by the learning
//   shown    every path was decided, every regular root is certified, and the learning is complete
//   open     neither
#pragma once

#include "moivre/family/family.h"

namespace moivre {

/// Throws std::invalid_argument when p has another size than the family, or options are out of
/// range.
SolveResult solve_member(const Family& family, const ParameterValues& p, const Tracker& tracker,
                         const SolveOptions& options = {},
                         const std::atomic<bool>& stop = std::atomic<bool>{false});

/// The start that the family gives to `member`, its system at p.
GivenStart start_of_member(const Family& family, const ParameterValues& p, const System& member);

}  // namespace moivre
