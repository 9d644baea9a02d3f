// SPDX-License-Identifier: MIT
// Which other curve of postures comes so near to this one that paths and searches see one curve?
//
//   sigma_2   of the screws at a sample, second from the least: beside a crossing the tip can move
//             next to nothing along a second direction
//   circle    round such a sample, in the plane of its two weakest directions; across it places are
//             put right, and the pose is missed least at each curve that passes
// Two of three axes that are nearly in line stay so along each of two curves, 1e-7 apart.
// Edges: a curve that comes near between two samples and nowhere else may be missed. Surfaces are
// not looked at. Private to the module.
#pragma once

#include <vector>

#include "set_place.h"

namespace moivre {

/// Where Newton's method is begun for postures of curves that come near, this one among them.
std::vector<Eigen::VectorXd> near_curves(const Arm& arm, const Eigen::Isometry3d& pose,
                                         const std::vector<Eigen::VectorXd>& samples,
                                         double accuracy);

}  // namespace moivre
