// SPDX-License-Identifier: MIT
// Into which parts does a mechanism fall that share only the ground and what the drivers alone
// place?
//
// A body is placed by the drivers where it stands in one pose whatever the others do: welded to a
// placed body, or tied to one by a single revolute or prismatic joint whose angle or slide is
// driven. The ground is placed. The other bodies are joined by their joints, gears (with carriers)
// and drivers; each connected piece, with all placed bodies, is a sub-chain. Given the drivers,
// each has its closures and moves on its branches whatever the others do: closures of the whole are
// one of each.
// Six legs on one crank are six sub-chains.
// Edges: fewer than two pieces: none, the mechanism is its own. A placed body with another joint to
// a placed body counts as not placed, since that joint may contradict the others.
// Not supported: typed equations; they are not taken apart.
#pragma once

#include <vector>

#include "moivre/closures/closures.h"

namespace moivre {

/// Two or more, or none.
std::vector<IndependentChain> independent_chains(const Mechanism& mechanism);

}  // namespace moivre
