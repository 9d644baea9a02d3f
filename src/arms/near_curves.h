// SPDX-License-Identifier: MIT
// Which other curves of postures cross this one, or come so near that paths and searches see one?
//
//   sigma_2   of the screws, second from the least: where it is 0 along the curve another one
//             crosses, and where it is next to 0 one comes near
//   circle    round such a place, or one where a path stopped, in the plane of its two weakest
//             directions; across it places are put right, and the pose is missed least at each
//             curve that passes
// Two of three axes that are nearly in line stay so along each of two curves, 1e-7 apart.
// Edges: curves that touch and do not cross may be taken for one. Surfaces are not looked at.
// Private to the module.
#pragma once

#include <vector>

#include "set_place.h"

namespace moivre {

/// Where Newton's method is begun for postures of such curves, this one among them.
std::vector<Eigen::VectorXd> near_curves(const Arm& arm, const Eigen::Isometry3d& pose,
                                         const std::vector<Eigen::VectorXd>& samples,
                                         double accuracy);

/// The same next to one place, where the tip can move as little along two directions; otherwise
/// nothing.
std::vector<Eigen::VectorXd> near_curves(const Arm& arm, const Eigen::Isometry3d& pose,
                                         const SetPlace& place, double accuracy);

}  // namespace moivre
