// SPDX-License-Identifier: MIT
// To which real postures does one come from a complex place, along a set on which the pose is held?
//
// Paths slide along the continuation of a set into complex numbers and stop there, more slowly than
// rounding lets them be followed. Where a set is a plane its relations tell of its continuation;
// one that is bent is followed back: from the place on along the directions in which the tip hardly
// moves, complex ones, so that the imaginary parts become less, and back to the pose across them.
// accuracy: radians, and lengths relative to the arm's. Edges: a set of complex places without real
// ones leads nowhere. Private to the module.
#pragma once

#include <optional>

#include "tip.h"

namespace moivre {

/// A real place on the set; nothing where the pose is left on the way, or no way is.
std::optional<Eigen::VectorXd> real_place_of(const Arm& arm, const Eigen::Isometry3d& pose,
                                             const JointVector<Complex>& from, double accuracy);

}  // namespace moivre
