// SPDX-License-Identifier: MIT
// Which exact pose did the file mean? Points and turns of a joint's frame as a rational dual
// quaternion.
//
// Rounded axes and angles are no rotations, and equations with such coefficients have roots at 1e16
// instead of none. A quaternion needs no norm: any four rationals turn by some angle, within
// rounding of the one meant.
#pragma once

#include <Eigen/Core>

#include "moivre/numeric/dual_quaternion.h"
#include "moivre/numeric/rational.h"

namespace moivre {

using ExactPose = DualQuaternion<Rational>;

/// x, a number near 1 or below, cleaned of the bits that square roots leave to chance: what was
/// meant as 1 is 1.
Rational without_noise(double x);

/// A shift to a point, whose coordinates are the decimals that were typed.
ExactPose shift_to(const Eigen::Vector3d& point);
ExactPose turn_about_z(double angle_rad);
/// The joint's frame (mechanism/pose.h) that has its z axis along `axis`: exactly, where all
/// directions of it are fractions as typed, else rounded.
ExactPose frame_of(const Eigen::Vector3d& axis);
/// Whether it is exact: (0, 0.6, 0.8) and two directions across it are of length 1.
bool has_exact_frame(const Eigen::Vector3d& axis);
/// A turn by the quaternion q, of any norm: its largest entry becomes 1.
ExactPose turn_by(const Quaternion<double>& q);
/// z tilted about x by the angle whose half has this tangent.
ExactPose tilt(const Rational& half_tangent);

/// A turn that lays the z axis along x (k = 0) or y (k = 1).
ExactPose across(std::size_t k);

/// |q|^2
Rational norm(const ExactPose& pose);

DualQuaternion<double> to_double(const ExactPose& pose);

}  // namespace moivre
