// SPDX-License-Identifier: MIT
// Which branches begin in a dead point at `from`, or end in one at `to`?
//
// A slide that is driven over its whole stroke goes from one dead point to the other. No step goes past such an end, so that none is seen to
// turn back. There the closure is double, and both branches that meet in it are known. With l' Phi_q = 0 it is a dead point where
// l' Phi_t != 0 (no velocity holds the drivers' law), and else a crossing.
// Edges: closures of higher multiplicity, and poses of a larger null space, are left as they are.
#pragma once

#include "scene.h"

namespace moivre {

/// Gives those tracks their events; what was sampled in the dead point itself, where there is no velocity, goes.
void mark_dead_ends(MotionRun& run, std::vector<Scene>& scenes);

}  // namespace moivre
