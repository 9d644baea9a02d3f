// SPDX-License-Identifier: MIT
// Which displacement does a 4 x 4 matrix of Python mean?
#pragma once

#include <Eigen/Geometry>
#include <string>

namespace moivre::python {

/// With the nearest rotation. Throws std::invalid_argument, whose text begins with `where`, unless
/// that is within `accuracy` (radians), or the matrix is a rotation and a translation to six
/// digits. `remedy`: which argument says that a pose is less accurate.
Eigen::Isometry3d pose_of(const Eigen::Matrix4d& matrix, const std::string& where,
                          double accuracy = 0, const std::string& remedy = "");

}  // namespace moivre::python
