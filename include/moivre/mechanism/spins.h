// SPDX-License-Identifier: MIT
// Which bodies turn about a line while everything else stands still, and how is such a turn held?
//
// Bodies that two spherical joints alone tie to others turn about the line through the joints: the
// coupler of an RSSR, the leg of a platform between two balls, whose slide is driven. Bodies that
// cannot turn against each other count as one.
// The turn is held by one row: seen along the line d, a direction e of the body points as the same
// direction e of the ground,
//   d . (R e x e) = 0,   d = B - A,   R the body's orientation
// so that the pose drawn with R = I stays. No rule without an exception exists (the hairy ball):
// here it is a line d or R^T d along e, which is no direction that anything is drawn in. Of the two
// solutions the one with R e on the side of e is meant.
// A body also turns idly about the axis of a revolute or cylindrical joint that all its other
// joints let it turn about, as a piston with a ball on its axis does. That joint's angle is free,
// and holding it holds the turn.
// In a plane a body turns idly about a pin that all its joints share, as a block on a crank's pin
// does that a slot alone leads.
// Edges: joints at one point, or to one and the same body, hold no line: no spin. A body with a
// driven point has none either, nor has one with a cylinder beside the line whose length has
// limits.
// Not supported: a body between a ball and a plane; several bodies that turn together, as a strut
// of free length between two balls does;
// joints of the second kind at different bodies of one group.
#pragma once

#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// In the order of their bodies; none of a planar mechanism or of typed equations.
std::vector<Spin> find_spins(const Mechanism& mechanism);

/// A body that turns about a joint's axis while everything else stands. The joint is revolute or
/// cylindrical, and not driven.
struct IdleTurn {
  std::size_t body = 0;
  std::size_t joint = 0;
};

/// In the order of their bodies, one a body.
std::vector<IdleTurn> find_idle_turns(const Mechanism& mechanism);

/// Whether each held spin is at the solution that is meant: elsewhere its body has turned by half a
/// turn, and the pose is the same but for it.
bool are_spins_as_meant(const Mechanism& mechanism, const Eigen::VectorXd& q);

/// e, a unit vector.
Eigen::Vector3d spin_mark();

}  // namespace moivre
