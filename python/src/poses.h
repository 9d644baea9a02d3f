// SPDX-License-Identifier: MIT
// Which displacement does a 4 x 4 matrix of Python mean?
#pragma once

#include <Eigen/Geometry>
#include <string>

namespace moivre::python {

/// Throws std::invalid_argument, whose text begins with `where`, unless the matrix is a rotation
/// and a translation to six digits.
Eigen::Isometry3d pose_of(const Eigen::Matrix4d& matrix, const std::string& where);

}  // namespace moivre::python
