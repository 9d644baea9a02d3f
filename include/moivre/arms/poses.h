// SPDX-License-Identifier: MIT
// Where must the tip be? Poses typed as seven numbers, x y z and a unit quaternion qw qx qy qz, on
// the command line or in a file.
//
// One pose per line, with blanks, commas, semicolons or tabs between the numbers. Empty lines,
// lines that begin with # and a first line of names are skipped. The quaternion may be rounded: it
// is scaled to length 1. It is refused if its length differs from 1 by more than kRoundedBy.
// A pose is as accurate as its digits: 2 units of the last decimal of the number that has most,
// three to eleven. With fewer decimals it is meant as it stands, with more it is a computed one.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "moivre/expression/source.h"

namespace moivre {

/// A quaternion typed with two decimals is as near to length 1.
inline constexpr double kRoundedBy = 0.02;

/// A pose, and how well it is known.
struct TypedPose {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  double accuracy =
      0;  ///< metres (the file's unit) and radians; below kReach (arm_closures.h) it is that
};

/// Throws ParseError with every fault, also if there is no pose.
std::vector<TypedPose> read_poses(const Source& source);

}  // namespace moivre
