// SPDX-License-Identifier: MIT
// In which ways does a leg of three parallel hinges stand, when what it joins is placed? Two
// postures, one unknown after the other.
//
// The leg is two links between groups i and k (rigid_groups.h), which it lets move like a planar
// joint. In the frame of its first hinge w(t2) is the place of the last hinge before the first
// turn, b its true place:
//   |w(t2)|^2 = |b|^2                  quadratic in t2, the turn between the links
//   the first turn brings w to b       linear in t1 (turned_places.h)
// Edges: links of one length whose outer hinges are in line may turn about them at will.
#pragma once

#include "spatial_frame.h"

namespace moivre {

/// Adds the leg's unknowns and equations, and places its links. `k_in_i`: the pose of the group
/// behind its last hinge in that before its first.
void add_postures(SpatialFrame& frame, const RigidGroups& groups, const PlanarLeg& leg,
                  const MovingPose& k_in_i);

}  // namespace moivre
