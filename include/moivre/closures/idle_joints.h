// SPDX-License-Identifier: MIT
// Which bodies can move while everything else stands still, and how are they held? One idle wheel
// would hide every closure.
//
// A body (with everything welded to it) that has a single joint and no driver has idle degrees of
// freedom: nothing depends on them. The same holds for wheels on their own pivots that mesh only
// with each other. The joint is held: it becomes a weld in the pose of the file's guess, else as
// drawn, within the joint's limits; in space always as drawn, a ball with both bodies' frames
// alike.
// Each weld holds one body to its neighbour, so chains are held link by link. Coordinates do not
// change; joints keep their numbers and names.
// In a plane a body whose joints all have one pin is held at it. In space a body between two balls
// spins about their line; the spin is held by a row of Phi (mechanism/spins.h), and no joint
// changes.
// Edges: no joint is held if that would hold the whole mechanism, as for a pendulum without a
// driver.
// Not supported: typed equations; they are returned unchanged.
#pragma once

#include <vector>

#include "moivre/closures/closures.h"

namespace moivre {

struct HeldMechanism {
  Mechanism mechanism;
  std::vector<IdleJoint> idle;  ///< in the order in which they were held
};

HeldMechanism hold_idle(const Mechanism& mechanism);

}  // namespace moivre
