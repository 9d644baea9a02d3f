// SPDX-License-Identifier: MIT
// Which ends cannot be right, and how are they settled? Paths that failed, jumped or met too close to be told apart.
//
// In doubt are
//   failed paths
//   simple roots at which two paths end: one of them has jumped
//   singular isolated roots whose winding numbers make no whole cycles: a path is missing or one is too many
//   ends on a set of positive dimension along which F vanishes but for rounding: in double-double they may be simple roots
// They are followed once more, with all care and by the other tracker where there is one, then in double-double. What stays in doubt has failed. Where the
// tracker has lanes in double-double, paths that failed by precision go there first.
// Where as many roots are proved as a proved bound allows, nothing is in doubt (completeness.h); that is asked before anything
// is followed again.
// An interrupted run is left as it is.
#pragma once

#include "run.h"

namespace moivre {

void settle_doubts(Run& run);

/// Behind part_clusters(), in more digits than double-double: ends that do not add up to the exact count, and clusters behind which no exact
/// count stands. Where one path of a cluster comes to a simple root, so do the others; a regular end without a proof leaves it undecided,
/// since no multiple root has one.
void climb_at_last(Run& run);

}  // namespace moivre
