// SPDX-License-Identifier: MIT
// Which ends of branches are one place? Those at one event, and those a turn of the drivers apart.
//
// Over the turn the last poses are compared with the first ones, angles to the nearest turn
// (same_pose.h). Where such an end is at an event, as a dead point that stands at `from` itself,
// the join is of that kind.
// Not joined: what a joint's limit ends.
#pragma once

#include "moivre/motion/circuits.h"

namespace moivre {

/// Whether a whole turn more of the driver is the same pose.
bool may_turn(const Mechanism& mechanism, const Driver& driver);

/// Whether the drivers stand at `to` as at `from`, but for whole turns, and nothing else depends on
/// the time.
bool drivers_return(const Mechanism& mechanism, const MotionResult& motion);

std::vector<BranchJoin> branch_joins(const Mechanism& mechanism, const MotionResult& motion);

}  // namespace moivre
