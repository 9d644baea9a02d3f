// SPDX-License-Identifier: MIT
// Which bodies can move while everything else stands, and how are they held? A wheel that spins idly hides every closure.
//
// A body (with what is welded to it) that one joint alone ties to the others, and no driver touches, has freedoms on which
// nothing depends; so has a set of wheels on pivots of their own that mesh with each other alone. The joint is held: it becomes
// a weld in the pose that the file's guess gives it, else as it was drawn, within the joint's limits. What is held is one body
// with its neighbour, so that chains are held link by link.
// Coordinates stay what they are; the joints keep their numbers and names.
// Edges: where all that could be held would hold the whole mechanism, as of a pendulum without a driver, nothing is.
// Not supported: spatial mechanisms and typed equations; they come back as they are.
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
