// SPDX-License-Identifier: MIT
// In which order do closures stand, whatever found them? Largest first coordinate first, ties by
// the second, and so on.
//
// The order depends on the poses alone: not on the seed, the tracker, the threads or the numbers of
// the paths. Two values of a coordinate tie where they, or values between them, lie within
// kSameCoordinate; at half a turn an angle is +pi, and a rotation vector points to where its first
// coordinate that is not zero is positive.
// Poses nearer to each other than that in every coordinate keep the order in which they came.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// Two values of a coordinate are one below this, on the scale of the largest length: above the
/// accuracy of a double closure (the square root of rounding, 1.5e-8), below what tells closures
/// apart.
inline constexpr double kSameCoordinate = 1e-6;

/// Positions in `poses`, in canonical order. poses: q each, angles in (-pi, pi], in the order of
/// `coordinates`. length: the mechanism's own (Phi::length()), below which a coordinate may be
/// rounding.
std::vector<std::size_t> canonical_order(const std::vector<Eigen::VectorXd>& poses,
                                         const std::vector<Coordinate>& coordinates, double length);

}  // namespace moivre
