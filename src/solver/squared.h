// SPDX-License-Identifier: MIT
// What is solved in the place of a system that is not square? As many equations as unknowns, and
// what they add is taken back.
//
//   homogeneous groups   a linear patch a . x_j = 1 for each (polynomial/patches.h); roots are told
//                        in coordinates of which one is 1 in each group
//   m > n                n random combinations (polynomial/square_up.h); a root of theirs that an
//                        equation of F refutes is excess
//   m < n                refused, or cut by n - m random linear equations where SolveOptions::slice
//                        says so: witness points
//
// An equation is refuted where it is larger, beside the sum of its terms' sizes, than kHolds and
// what the root's accuracy leaves open. Private to the module.
#pragma once

#include "moivre/solver/solve.h"

namespace moivre {

/// F as it is solved. Throws std::invalid_argument where m < n and nothing is to be sliced.
System squared(const System& f, const SolveOptions& options);

/// From a result on squared(f, ...): excess roots dropped and counted, coordinates of homogeneous
/// groups normalized, and a sentence for what was done.
void take_back(const System& f, const SolveOptions& options, SolveResult& result);

}  // namespace moivre
