// SPDX-License-Identifier: MIT
// Which rules do an arm, its joint values and a pose break? What takes them refuses them, with
// every broken rule named (InvalidInput).
//
// A pose is finite and its rotation right-handed and orthonormal, but for rounding: one that is
// typed with two decimals is replaced by the nearest rotation, as a typed quaternion is
// (arms/poses.h). One that is scaled, sheared or mirrored is refused.
#pragma once

#include <string>

#include "moivre/arms/arm.h"

namespace moivre {

/// Throws InvalidInput where an arm breaks a rule.
void require_unbroken(const Arm& arm);
/// Throws InvalidInput where values are not one finite number for each joint.
void require_values(const Arm& arm, const Eigen::VectorXd& values);

/// The rotation nearest to a matrix R = U sigma V^T that is nearly one: U V^T.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& R);

/// The pose with the nearest rotation; the same pose where that is off by rounding only. Throws
/// InvalidInput as above; `name` is what messages call it: "the pose", "pose 3".
Eigen::Isometry3d workable_pose(const Eigen::Isometry3d& pose, const std::string& name);

}  // namespace moivre
