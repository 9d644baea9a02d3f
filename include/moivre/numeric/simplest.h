// SPDX-License-Identifier: MIT
// Which fraction may this number have been? The one of least denominator within an error, by
// Euclid's algorithm.
//
//   the continued fractions of both bounds are the same up to a place; there the smaller of the two
//   next integers is taken Edges: 0 where it lies between the bounds; of several whole numbers the
//   one nearest to 0. x and error are finite, error >= 0.
// Source: [GKP94, section 4.5], on the Stern-Brocot tree.
#pragma once

#include <vector>

#include "moivre/numeric/complex.h"
#include "moivre/numeric/rational.h"

namespace moivre {

/// Within [x - error, x + error]. Throws std::invalid_argument where the error is negative or not
/// finite, or x is not finite.
Rational simplest(double x, double error);

/// Every part of every coordinate, each within error * max(1, |x_i|). Throws as the other.
std::vector<Coefficient> simplest(const Point& x, double error);

}  // namespace moivre
