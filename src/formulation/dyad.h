// SPDX-License-Identifier: MIT
// Which 3-space do the poses of two joints in a row span, and how do three joints lie in one?
//
// Basis b_ij = b_i(A) b_j(B), in the order 00, 01, 10, 11; normals: linear forms that vanish on it,
// four unless the axes are one. Both are exact: a linkage that moves by its dimensions satisfies
// the equations along a whole curve, and with rounded normals it would only nearly do so. Lengths
// count in units of `length`, so that turns and shifts weigh alike.
#pragma once

#include <array>
#include <vector>

#include "joint_loop.h"

namespace moivre {

struct DyadSpace {
  std::array<ExactPose, 4> basis;
  std::vector<ExactPose> normals;
  std::array<ExactPose, 4> coordinates;  ///< linear forms that give a pose's in the basis
};

DyadSpace dyad_space(const LoopElement& a, const LoopElement& b, double length);

/// Unknown coordinates for the dyad of a and b, with their patch; b comes behind a.
std::array<Polynomial, 4> add_dyad_coordinates(SpatialFrame& frame, const LoopElement& a,
                                               const LoopElement& b);

/// The pose that has these coordinates.
MovingPose pose_in(const DyadSpace& space, const std::array<Polynomial, 4>& coordinates);

/// c00 c11 = c01 c10, but for rounding: where the loop's geometry makes it hold everywhere, nothing
/// else is left.
void add_quadric(SpatialFrame& frame, const LoopElement& a, const std::array<Polynomial, 4>& c);

/// The unknowns of a and b, whose dyad has the coordinates c.
void add_half_angles(SpatialFrame& frame, const LoopElement& a, const LoopElement& b,
                     const std::array<Polynomial, 4>& c);

/// Coordinates of a pose in the basis; meaningful where it lies in the space.
std::array<Polynomial, 4> coordinates_in(const DyadSpace& space, const MovingPose& pose);

/// 0 where every pose of the 3-space is on Study's quadric (axes that meet or are parallel), else
/// how far it bends off it.
double distance_from_quadric(const LoopElement& a, const LoopElement& b, double length);

/// Whether all products of the three lie in one 3-space: parallel axes, or axes through one point.
bool spans_common_space(const LoopElement& a, const LoopElement& b, const LoopElement& c,
                        double length);

}  // namespace moivre
