// SPDX-License-Identifier: MIT
// Where one unknown is left all roots are known by proof (certify/isolate.h). Which path ends at which?
//
// As many paths are followed as the polynomial has roots, with their multiplicities. A path whose end is proved keeps it; what is left of
// the roots goes to the other paths, each to the nearest end.
// Edges: a root far from every end that is left is none of theirs, and nothing is changed. Private to the module.
#pragma once

#include "run.h"

namespace moivre {

/// Whether every path now has a root that is proved, simple or with its multiplicity. False as well where more unknowns are left, the
/// coefficients are not real, or nothing is in doubt.
bool settle_by_isolation(Run& run);

}  // namespace moivre
