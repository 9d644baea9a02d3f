// SPDX-License-Identifier: MIT
// Exact algebra counts more roots than are proved: which are the others, and which paths lead to
// them?
//
// The quotient ring that counts them has their coordinates too (certify/ring_points.h). Each simple
// one is proved on the system as given, and goes to a path whose end is not proved: one of these
// leads to it, since every simple root has a path. Of several it is the one that was last seen
// nearest. Where the ring tells all multiplicities the multiple roots are known exactly, and get
// what is left of the paths as those that are fractions do (completeness.h).
// Edges: not where more digits are not to be had, or not allowed, or every path is to be followed:
// what is asked for then is what the paths tell. Two multiple roots at one point of double stay
// with the paths; no more than 128 roots, few digits; costs no more than the paths in doubt would
// in more digits.
// Private to the module.
#pragma once

#include "run.h"

namespace moivre {

/// Throws Interrupted.
void give_missing_roots(Run& run);

}  // namespace moivre
