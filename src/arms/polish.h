// SPDX-License-Identifier: MIT
// Which joint values near these hold the pose? Newton's method on the product of transforms; no
// polynomial is seen here.
//
// Error: translation relative to the arm's length, and the rotation vector from the tip's
// orientation to the pose's. Jacobian of screws, columns z x (tip - p), z of a turn, z, 0 of a
// slide. Steps are least squares of least norm, directions that move nothing left out; damped where
// asked, for starts that are far away.
#pragma once

#include "moivre/arms/arm_closures.h"
#include "tip.h"

namespace moivre {

/// The pose as seen from the tip at some joint values.
struct Linearized {
  Velocity6<double> error;  ///< translation relative to the arm's length, rotation vector
  Screws<double> screws;
};
Linearized linearized(const Arm& arm, const Eigen::Isometry3d& pose,
                      const JointVector<double>& values);
/// The larger of both errors.
double size_of(const Velocity6<double>& error);

/// An error that is smaller is rounding.
inline constexpr double kRoundingError = 1e-13;
/// A smaller one is none, as far as double tells.
inline constexpr double kLeastError = 1e-14;

struct Polished {
  JointVector<double> values;
  double residual = 0;  ///< the larger of both errors
  int iterations = 0;
  double smallest_singular_value = 0;
  double screws_square = 0;  ///< the sum of the squares of all numbers of the screws
  JointVector<double>
      least_moving;  ///< unit: the direction of joint values that moves the tip least
  Velocity6<double>
      least_moved;  ///< unit: translation and rotation of the tip that take the fastest joints
};

/// In the arm's own units instead of radians and arm's lengths.
WeakestMotion weakest_motion(const Arm& arm, const Polished& closure);

Polished polish(const Arm& arm, const Eigen::Isometry3d& pose, const JointVector<double>& start,
                bool is_damped = false);

}  // namespace moivre
