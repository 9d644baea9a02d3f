// SPDX-License-Identifier: MIT
// How freely does a mechanism move at each of its closures? A folded pose may be freer than all others.
//
// Closures of the same ranks, with the drivers and without them, are one kind. The generic kind has the highest rank: its
// degrees of freedom hold nearly everywhere. If closures form a set, the pose found on the set is one more closure.
#pragma once

#include <string>
#include <vector>

#include "moivre/closures/closures.h"

namespace moivre {

struct MobilityKind {
  std::vector<std::string> closures;  ///< ids; empty: a pose of the set of closures alone
  Eigen::VectorXd q;                  ///< of the first
  Mobility mobility;                  ///< there
};

/// The generic kind first; empty where there is no closure.
std::vector<MobilityKind> mobility_kinds(const Mechanism& mechanism, const ClosureResult& result);

}  // namespace moivre
