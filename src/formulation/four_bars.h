// SPDX-License-Identifier: MIT
// In which ways does a planar four-bar between two hinges stand, when what it joins is placed? Two
// postures, one unknown after the other.
//
// The bar turns about a line a of group i, the foot about a line b of group k; two links join them
// by hinges normal to both lines, which lie in the plane of the four-bar (rigid_groups.h).
//   n(t1) (r b + r' c) = 0             the normal of that plane, turned with the bar, is normal to
//                                      the place b and the direction c of the other line: n or -n
//   the foot's turn brings its normal to n             linear (turned_places.h)
//   each link's turn brings its far hinge to line b        linear
// Edges: where both lines are one the bar may turn about them at will.
#pragma once

#include "spatial_frame.h"

namespace moivre {

/// Adds the four-bar's unknowns and equations, and places its links. `k_in_i`: the pose of the
/// group that the foot is hinged to in that of the bar's.
void add_postures(SpatialFrame& frame, const RigidGroups& groups, const FourBarLeg& four_bar,
                  const MovingPose& k_in_i);

}  // namespace moivre
