// SPDX-License-Identifier: MIT
// Where do the joints of one pin begin? At the body that is placed first, so that all of them hold
// one and the same point.
//
// Three bodies on a pin are typed as two revolute joints, a tree over their points: A-B, B-C.
// Written so, C is tied to A's place by way of B: two roundings of one point, where A and B are
// known already. A star A-B, A-C says the same, since (C - B) + (B - A) = C - A, and what hangs on
// the pin later meets one value.
// Not supported: pins whose joints are no tree (one says what the others say); they stay as typed.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// The two points that each joint holds together.
using JointEnds = std::vector<std::array<PointOf, 2>>;

/// Whether star_ends would change anything.
bool has_shared_pins(const Mechanism& mechanism);

JointEnds typed_ends(const Mechanism& mechanism);

/// The same with a star for the joints of every pin of three points or more. `rank`: how early a
/// point's place is known, the least is the centre, among equals the one typed first.
JointEnds star_ends(const Mechanism& mechanism, const std::function<std::size_t(PointOf)>& rank);

}  // namespace moivre
