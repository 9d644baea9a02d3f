// SPDX-License-Identifier: MIT
// Where does a joint's origin put its child? As a rotation matrix, and which typed angles mean
// quarter turns.
//
// rpy = (r, p, y): R = Rz(y) Ry(p) Rx(r). An angle means k quarter turns where it is k pi/2 cut or
// rounded to the decimals that were typed, four at least: 1.5708 does, 1.5707963277 does not.
// Robots are built with right angles, but files have decimals. Without this rule axes would not be
// exactly parallel or meet.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "moivre/urdf/robot.h"

namespace moivre {

/// k, the quarter turns that a typed angle means; nothing if it is no multiple of pi/2 in its
/// digits.
std::optional<int> quarter_turns(const Rational& angle);

/// How many decimals the number has as typed; 30 where more.
int decimals(const Rational& number);

/// By how much a typed angle misses the quarter turns that it may stand for, in two decimals or
/// more; nothing where it stands for none.
std::optional<double> missed_right_angle(const Rational& angle);

/// R of the numbers as typed, to rounding.
Eigen::Matrix3d rotation(const ExactVector& rpy);

Eigen::Vector3d to_vector(const ExactVector& v);

}  // namespace moivre
