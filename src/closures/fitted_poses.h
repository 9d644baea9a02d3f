// SPDX-License-Identifier: MIT
// Which poses close within Mechanism::fit only? Least squares from the drawn pose, from beside
// roots, and from random poses.
//
//   strong  Phi_q fixes the pose, whatever fit allows (within_fit.h): all equations combined
//           should have a root beside it. Where they must, and have none, some were lost
//   weak    fit leaves it a way to go: at a fold, or where links in line make the linkage that is
//           meant movable. Its roots may be complex, far away or none. What local searches come to
//           is listed, once for all poses that hang together.
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

/// Under a fit: from the guess and from random poses; strong poses are counted in `rootless`.
void look_for_fitted(ClosureSearch& search);

/// Under a fit: Closure::play of all closures.
void measure_play(ClosureSearch& search);

}  // namespace moivre
