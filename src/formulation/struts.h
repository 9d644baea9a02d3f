// SPDX-License-Identifier: MIT
// In which ways does a strut stand, when what it joins is placed? Two postures, one unknown after
// the other.
//
// A strut is a link between two points A and B, with a universal joint at A (rigid_groups.h). In
// the frame of that joint's first axis a = k, w(t2) is the place of B before the first turn and b
// its true place:
//   w_z(t2) = b_z                              quadratic in t2: the two postures
//   the first turn brings w to b               linear in t1 (turned_places.h)
// Where B has a universal joint too, the strut's axis across AB, turned to n(t1), is normal to a
// and to the axis of the other group: these two lines meet. The line k moved by x + eps y has the
// direction c = x k conj(x) and the moment x k conj(y) + y k conj(x)
// [PottmannWallner01]; it meets k itself where the moment's third part is 0, a quadric in the pose.
// Then the first turn comes first:
//   n(t1) (r b + r' c) = 0                 quadratic in t1: n or -n. r and r' are random, as b or c
//                                          alone may lie along a, where the strut stands still,
//                                          although its place alone does not say so
//   the second turn brings B to its place  linear in t2, as above
#pragma once

#include "spatial_frame.h"

namespace moivre {

/// Adds the strut's unknowns and equations, and places it. `k_in_i`: the pose of its ball's group
/// in that of its cross.
void add_postures(SpatialFrame& frame, const RigidGroups& groups, const Strut& strut,
                  const MovingPose& k_in_i);

/// Vanishes where the z axes of the tie's frames, as lines, meet or are parallel.
Polynomial meeting_equation(SpatialFrame& frame, const Tie& tie, const MovingPose& j_in_i);

}  // namespace moivre
