// SPDX-License-Identifier: MIT
// Are two poses one? How far they are apart, angles to the nearest turn in radians and lengths
// beside the size of the mechanism's pose.
//
// q: n coordinates as in Phi.
#pragma once

#include <Eigen/Core>

#include "moivre/mechanism/phi.h"

namespace moivre {

/// Poses nearer than this are the same: both are corrected to rounding, unless they are nearly
/// singular.
inline constexpr double kSamePose = 1e-6;
/// Poses where branches meet are known to the root of that.
inline constexpr double kSamePlace = 1e-3;

/// Largest difference of two poses: of angles, in radians and to the nearest turn; of lengths,
/// beside the larger pose's size.
double distance(const Phi& phi, const Eigen::VectorXd& a, const Eigen::VectorXd& b);
/// Whether that is no more than kSamePose; where not, a length nearly always says so at once.
bool is_same_pose(const Phi& phi, const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace moivre
