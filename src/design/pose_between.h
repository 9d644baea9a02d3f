// SPDX-License-Identifier: MIT
// Where is the mechanism between two samples of a branch?
#pragma once

#include "moivre/kinematics/branch.h"

namespace moivre {

/// Newton's method from the quintic through both. `is_determined` is false where it does not settle
/// beside that, or Phi_q is singular.
BranchSample pose_between(const Phi& phi, const BranchSample& before, const BranchSample& after,
                          double time);

}  // namespace moivre
