// SPDX-License-Identifier: MIT
// Which turn about the z axis brings one point to another? Points as numerators over |q|^2.
//
// w and b at one height and one distance from the axis, c + s k the turn:
//   c (w - b) + s k x (w + b) = 0, x and y     linear in the turn's unknown. One is a multiple of
//                                              the other, so that a random sum of both says all
#pragma once

#include <string>

#include "spatial_frame.h"

namespace moivre {

/// Where a frame's origin is: 2 g conj(q) / |q|^2. Its first number is 0.
struct RationalPlace {
  Quaternion<Polynomial> numerator;
  Polynomial denominator;
};

RationalPlace place_of(const MovingPose& pose);

/// The direction of a frame's z axis likewise: q k conj(q) / |q|^2.
RationalPlace direction_of(const MovingPose& pose);

/// Adds what holds where the turn brings `from` to `to`.
void add_turn_equation(SpatialFrame& frame, const std::string& name, const MovingPose& turn,
                       const RationalPlace& from, const RationalPlace& to);

}  // namespace moivre
