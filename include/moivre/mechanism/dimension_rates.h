// SPDX-License-Identifier: MIT
// How do the constraints, and what is read off a pose, change with a dimension? Phi_p, and rates of
// points and joints.
//
//   Phi_p: m x p, column k = d Phi / d p_k at fixed q: the rows of Phi in their order, the
//   dimensions in theirs
// The formulas are those of Phi and of pose.h, in Taylor arithmetic along the dimension: exact to
// rounding.
// Angles in radians, lengths in the file's unit.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "moivre/mechanism/dimensions.h"

namespace moivre {

Eigen::MatrixXd partial_dimensions(const Mechanism& mechanism,
                                   const std::vector<Dimension>& dimensions,
                                   const Eigen::VectorXd& q, double t);

/// How fast the point moves while the dimension grows at rate 1 and q at qdot; null: no dimension
/// grows.
Eigen::Vector3d point_rate(const Mechanism& mechanism, const PointOf& point,
                           const Eigen::VectorXd& q, const Eigen::VectorXd& qdot,
                           const Dimension* dimension);

/// Likewise, of what joint_state (pose.h) tells.
std::optional<double> joint_rate(const Mechanism& mechanism, const Joint& joint,
                                 const Eigen::VectorXd& q, const Eigen::VectorXd& qdot,
                                 const Dimension* dimension);

}  // namespace moivre
