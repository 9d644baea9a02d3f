// SPDX-License-Identifier: MIT
// Remedies for ends that seem to lie on a set of positive dimension: is there a root of its own
// beside it, and is there a set at all?
//
// Private to the module.
#pragma once

#include "run.h"

namespace moivre {

/// A simple root so near to a set that double does not tell it from the set's points: its sheet and
/// one of the set's seem to meet, or the end may as well be a root that is proved beside it and
/// that no path has. In more digits its path has a regular end.
/// Or a multiple root: its sheets and one of the set's seem to meet at their mean, which is
/// neither. In more digits the latter has a regular end elsewhere.
void look_beside_sets(Run& run);

/// Where F all but vanishes along a set, simple roots pass for points of it. Paths to such a set
/// are followed in double-double: a root that is proved at the end of one is none of the set's.
/// Where there is such a root the set is none, and what the other paths end at is not known.
void look_at_blurred_sets(Run& run);

}  // namespace moivre
