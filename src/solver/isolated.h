// SPDX-License-Identifier: MIT
// Where one unknown is left all roots are known by proof (certify/isolate.h). Which path ends at
// which?
//
// As many paths are followed as the polynomial has roots, with their multiplicities. A path whose
// end is proved keeps it, unless another path has it; what is left of the roots goes to the other
// paths, each to the nearest end, or to a path of which nothing tells where its root is.
// Edges: where a root is far from every end that is left, and all of these are told, nothing is
// changed. Private to the module.
#pragma once

#include "run.h"

namespace moivre {

/// Every path gets a root that is proved, simple or with its multiplicity. Nothing is changed where
/// more unknowns are left, the coefficients are not real, or every path has one.
void isolate_roots(Run& run);

}  // namespace moivre
