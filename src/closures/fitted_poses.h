// SPDX-License-Identifier: MIT
// Which poses close within Mechanism::fit only? Least squares from the drawn pose, from beside
// roots, and from random poses.
//
// A pose that random starts alone come to has no root beside it. Where some equations are spare,
// all are combined then (closures.cpp). What still has no root is listed: at a fold, or where links
// in line make the linkage that is meant movable, roots may be complex, far away or none. Only
// where Phi_q fixes the pose so well that there must be a root (within_fit.h) some were lost.
// Closure::play says how far a listed pose reaches.
// Edges: random poses are given up where as many as the closures found so, and some more, come to
// nothing new; nothing found proves nothing.
#pragma once

#include "closure_search.h"
#include "moivre/kinematics/newton.h"

namespace moivre {

/// Newton-Raphson's run from the guess; under a fit from the least squares there, which end it
/// where it finds neither a closure nor these, as at a fold.
NewtonResult settled(const ClosureSearch& search, const Eigen::VectorXd& guess);

/// Enters what least squares came to as a closure, where it is within fit and hangs together with
/// none that is listed; true if so.
bool take_fitted(ClosureSearch& search, const NewtonResult& least);

/// Whether poses between these two are within fit, too.
bool hang_together(const ClosureSearch& search, const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// Under a fit: from the guess and from random poses. Poses that should have a root are counted in
/// `rootless`.
void look_for_fitted(ClosureSearch& search);

/// Under a fit: Closure::play of all closures.
void measure_play(ClosureSearch& search);

}  // namespace moivre
