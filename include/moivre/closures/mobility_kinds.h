// SPDX-License-Identifier: MIT
// How freely does a mechanism move at each of its closures? A folded pose may be freer than all
// others.
//
// Closures of the same ranks, with the drivers and without them, are one kind. The generic kind has
// the highest rank: its degrees of freedom hold nearly everywhere, unless the rank is higher next
// to it: then no closure is generic (Mobility::is_singular). If closures form a set, the pose found
// on the set is one more closure, and so is the one next to it on the set of the highest rank.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/closures/closures.h"
#include "moivre/kinematics/newton.h"

namespace moivre {

struct MobilityKind {
  std::vector<std::string> closures;  ///< ids; empty: a pose of the set of closures alone
  Eigen::VectorXd q;                  ///< of the first
  Mobility mobility;                  ///< there
};

/// The kind of the highest rank first; empty where there is no closure.
std::vector<MobilityKind> mobility_kinds(const Mechanism& mechanism, const ClosureResult& result);

/// The mobility of a mechanism, and of which pose it is.
struct FoundMobility {
  std::vector<MobilityKind> kinds;  ///< of its closures; empty: there is but the pose from a guess
  NewtonResult
      pose;  ///< that Newton-Raphson leads to from the guess, or from the generic kind's closure
  Mobility mobility;  ///< there
};

/// At the closures of the time t, where no guess is given, neither here nor by the mechanism, and
/// closures of a planar mechanism can be found; else at the pose that Newton-Raphson finds from the
/// guess.
FoundMobility find_mobility(const Mechanism& mechanism, const Tracker& tracker, double t = 0,
                            const std::optional<Eigen::VectorXd>& guess = {},
                            const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
