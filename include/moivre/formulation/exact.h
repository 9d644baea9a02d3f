// SPDX-License-Identifier: MIT
// Which exact number does a double stand for? The typed decimal, a point of the unit circle, or the double itself.
#pragma once

#include "moivre/numeric/complex.h"
#include "moivre/numeric/rational.h"

namespace moivre {

/// The shortest decimal that reads back as x: what a person typed. Requires a finite x.
Rational typed_decimal(double x);

/// x + iy, both as typed_decimal.
Coefficient typed_decimal(double x, double y);

/// L |L|, of the decimal that was typed: no two points are a length below 0 apart.
Rational signed_square(double length);

/// A rational c within 4 units of rounding of exp(i phi) with c conj(c) = 1 exactly; whole quarter turns give 1, i, -1, -i.
Coefficient unit_at(double phi);

/// z without rounding.
Coefficient exactly(Complex z);

Coefficient conjugate(const Coefficient& c);

}  // namespace moivre
