// SPDX-License-Identifier: MIT
// How freely does a mechanism move at each of its closures? A folded pose may be freer than all others.
//
// Closures of one rank, with drivers and without, are one kind. The generic kind is that of the highest rank: its degrees of
// freedom are those nearly everywhere. Where closures form a set, the pose of the set that was found is one more.
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
