// SPDX-License-Identifier: MIT
// Which exact number does a double stand for? The typed decimal, a point of the unit circle, or the
// double itself.
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

/// As it was typed: degrees pi / 180 + radians, no further than `error` (rad) from the angle that
/// is meant.
struct ExactAngle {
  Rational degrees;
  Rational radians;
  double error = 0;
};

/// A direction that is known to lie near a rational one: exp(i phi) = value w, |w - 1| <= error,
/// value conj(value) = 1 exactly.
struct EnclosedUnit {
  Coefficient value{1, 0};
  double error = 0;
};

/// Rational directions are as near as this to those that are meant, where the angle is known
/// exactly.
inline constexpr double kUnitError = 0x1p-126;

/// Whole quarter turns give 1, i, -1, -i: typed in degrees they are exact; radians are taken for
/// one where nothing but their rounding is left, which is then the error.
EnclosedUnit unit_at(const ExactAngle& phi);

EnclosedUnit operator*(const EnclosedUnit& a, const EnclosedUnit& b);
EnclosedUnit conjugate(const EnclosedUnit& a);

/// z without rounding.
Coefficient exactly(Complex z);

Coefficient conjugate(const Coefficient& c);

}  // namespace moivre
