// SPDX-License-Identifier: MIT
// Where shall the tip be? Poses typed as seven numbers, x y z and a unit quaternion qw qx qy qz, one on the command line or a file of many.
//
// A line a pose; blanks, commas, semicolons or tabs between the numbers. Empty lines and those that begin with # are passed over, so
// is a first line of names. The quaternion may be rounded: it is scaled to length 1, one that misses it by more than kRoundedBy is refused.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "moivre/expression/source.h"

namespace moivre {

/// A quaternion typed with two decimals is as near to length 1.
inline constexpr double kRoundedBy = 0.02;

/// Throws ParseError with every fault, also where there is no pose.
std::vector<Eigen::Isometry3d> read_poses(const Source& source);

}  // namespace moivre
