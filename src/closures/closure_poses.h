// SPDX-License-Identifier: MIT
// Which poses are the real roots? Each polished by Newton-Raphson on Phi, told from poses that
// move, held against the limits.
//
// Poses stand in canonical order (canonical_order.h) and are lettered in it.
// Edges: a root whose pose is one of many is no isolated root after all; its paths are counted
// anew. A real root that Newton-Raphson does not confirm has no pose, and is counted as unpolished.
#pragma once

#include "closure_search.h"
#include "moivre/kinematics/newton.h"

namespace moivre {

/// Fills closures and counts; leaves the isolated roots alone among the solutions.
void find_poses(ClosureSearch& search);

/// Whether the joints' limits allow the pose; where they do not, the joint counts it.
bool is_allowed(ClosureSearch& search, const Eigen::VectorXd& q);

/// Says how many closures each joint's limits filtered.
void tell_limits(ClosureSearch& search);

/// Whether Newton-Raphson came to a pose that satisfies spare constraints too.
bool closes(const ClosureSearch& search, const NewtonResult& pose);

/// Whether it closes where a root is, or on a set: beside a fold what closes to rounding may have
/// complex roots alone, and is a pose within Mechanism::fit.
bool is_at_root(const ClosureSearch& search, const NewtonResult& pose);

/// Is this pose of a multiple root, or one that Newton-Raphson came to, one of many? Then it is
/// told as the one that moves.
bool lies_on_motion(ClosureSearch& search, const Eigen::VectorXd& q);

/// Whether teeth may mesh in more ways than the drawn one.
bool has_gears(const Mechanism& mechanism);

/// Whether a pose that Newton-Raphson came to, and that is no closure found, shows that one was
/// lost.
bool shows_a_loss(const ClosureSearch& search, const NewtonResult& pose);

/// Keeps the least misfit of poses that do not close, and where it is.
void note_misfit(ClosureSearch& search, const Closure& pose);

/// The closure at the end of a Newton run, its path and kind not yet said.
Closure closure_at(const ClosureSearch& search, const NewtonResult& polished);

/// Puts closures in canonical order and names them by it.
void letter(std::vector<Closure>& closures, const Phi& phi);

}  // namespace moivre
