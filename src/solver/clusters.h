// SPDX-License-Identifier: MIT
// Is it one multiple root, or are they simple roots nearer to each other than the paths' digits
// tell? Proofs part them.
//
//   m paths end within r of x and say: one root of multiplicity m. Newton's method in Arb's balls
//   sets out from points x + r d around it, d where F changes least: at m simple roots it comes to
//   one of them, from opposite sides of two roots to both; at a root of multiplicity m, a bit or
//   less nearer a step, to nothing that could be proved.
//
// m roots proved that no other path holds: the m paths end at them, one each. Fewer: what is told
// is not true, and the paths have failed.
// None: a root of multiplicity m, as far as the most bits of a certificate show. Where fractions
// within r of x are a root, exactly, its local ring tells (algebra/local_multiplicity.h): if it
// has dimension m nothing is looked for, and if its dimension is another or larger, x is no
// isolated root of that multiplicity. Then it lies on a curve, if the ring grows like that of one,
// or the paths have failed. Elsewhere its ring has to be shown numerically
// (algebra/numerical_multiplicity.h): as many dimensions as paths, and no more.
// What is not shown has failed.
// Edges: roots of a cluster so near that the bits do not part them; a ring of too many
// monomials is not looked at.
#pragma once

#include "run.h"

namespace moivre {

void part_clusters(Run& run);

/// Places where several paths end and that exact algebra does not count as one root: simple ones as
/// near to each other as 1e-270? What is looked for in vain takes long, so that a few go first, and
/// others as long as that helps. What is not parted stays what it was.
void part_clusters_in_more_bits(Run& run);

/// Whether some path ends at this simple root, or at one that may be the same.
bool is_held(const Run& run, const Certificate& proof);

/// Whether exact algebra shows an isolated root of F at the end, or at the simplest fractions
/// within what is known of it.
bool is_exactly_isolated(const System& f, const Root& end);

}  // namespace moivre
