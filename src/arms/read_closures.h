// SPDX-License-Identifier: MIT
// Which closures do the roots of one pose's equations mean? Real ones put right, named, counted; what was left out, told.
//
// A root is read back to tangents of all joints, or rejected; Newton's method on the product of transforms gives the joint values.
#pragma once

#include "cut.h"
#include "moivre/arms/arm_closures.h"

namespace moivre {

/// "joint2, joint3".
std::string names_of(const Arm& arm, const std::vector<std::size_t>& joints);

/// Fills closures, counts, moves, left_out and the message of a result whose account is there; `complete` is taken back where roots
/// were not understood.
void read_closures(const Arm& arm, const Loop& loop, const Cut& cut,
                   const std::vector<Solution>& solutions, ArmResult& result);

}  // namespace moivre
