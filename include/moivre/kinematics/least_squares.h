// SPDX-License-Identifier: MIT
// At which pose near a guess do all constraints miss by least squares? Also where Newton-Raphson
// finds none: at a fold that does not close.
//
// |Phi| in own units (kinematics/own_units.h) has a minimum there. Where Phi_q is regular and
// square, the minimum is 0.
// Edges: the last pose of 60 steps where these do not suffice.
#pragma once

#include <Eigen/Core>

#include "moivre/mechanism/phi.h"

namespace moivre {

Eigen::VectorXd least_squares_pose(const Phi& phi, const Eigen::VectorXd& guess, double t = 0);

}  // namespace moivre
