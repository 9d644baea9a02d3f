// SPDX-License-Identifier: MIT
// How can a pose move on though the drivers stand? One direction in the coordinates, and how it is
// told.
#pragma once

#include <string>

#include "moivre/mechanism/phi.h"

namespace moivre {

/// The direction that Phi_q sees least at q, of length 1 where lengths are taken relative to the
/// mechanism's (angles in radians, n entries):
/// the motion itself where there is one, else what comes nearest to one.
Eigen::VectorXd free_motion(const Phi& phi, const Eigen::VectorXd& q, double t);

/// Entries that are not rounding noise, as "coupler.phi 0.3, coupler.x 12".
std::string direction_text(const Eigen::VectorXd& direction, const Mechanism& mechanism);

}  // namespace moivre
