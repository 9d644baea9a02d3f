// SPDX-License-Identifier: MIT
// How are origins, poses and axes written as dual quaternions of integers? Scaled until they are
// whole: a factor changes nothing.
#pragma once

#include <Eigen/Geometry>

#include "moivre/arms/arm.h"
#include "moivre/numeric/exact_displacement.h"

namespace moivre {

/// xyz, then rpy; angles that mean right angles are right, others are exact turns by them within
/// 2^-60.
ExactDisplacement exact_origin(const ExactVector& xyz, const ExactVector& rpy);
/// A turn by `angle` about `axis`, of any length.
ExactDisplacement exact_turn(const ExactVector& axis, double angle);
/// By `distance` along `axis`, of any length.
ExactDisplacement exact_slide(const ExactVector& axis, double distance);
/// The pose to the last bit of its translation and of the quaternion of its rotation.
ExactDisplacement exact_pose(const Eigen::Isometry3d& pose);
/// `step` of a turn or a slide (moivre/arms/arm.h), and the length of the whole numbers that it
/// has.
ExactDisplacement exact_step(const ExactVector& axis, bool is_slide);
/// The length of the axis in it: of a slide's, twice the dual part.
double exact_length(const ExactDisplacement& step, bool is_slide);

/// Lengths in units of 2^exponent.
ExactDisplacement in_unit(ExactDisplacement g, int exponent);

}  // namespace moivre
