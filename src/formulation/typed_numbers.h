// SPDX-License-Identifier: MIT
// Which exact number did a person type for an angle, and for what a driver prescribes at a time?
// How far may it be from that?
//
// An angle is kept in radians, rounded. What was typed in degrees is the shortest decimal of
// degrees that is rounded to it; one of more than fifteen digits may be another one, and the
// rounding is its error. A parabola's value is computed exactly from its typed numbers;
// a table's and a formula's in double, and enclosed by a bound on what rounding may have done.
#pragma once

#include "moivre/formulation/exact.h"
#include "moivre/mechanism/driver_law.h"
#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// What is computed in double is right to this, relative to what it is made of: a hundred
/// operations, each right to a few units of the last digit.
inline constexpr double kComputed = 0x1p-44;

/// |number - value| <= error.
struct EnclosedNumber {
  Rational value;
  double error = 0;
};

EnclosedNumber typed(double number);
ExactAngle typed_angle(double angle_rad, const Units& units);

/// What was computed in double from other numbers.
EnclosedNumber computed_number(double value);
ExactAngle computed_angle(double angle_rad);

ExactAngle plus(ExactAngle a, const ExactAngle& b);
ExactAngle times(const Rational& factor, ExactAngle angle);

ExactAngle driven_angle(const DriverLaw& law, double t, const Units& units);
EnclosedNumber driven_length(const DriverLaw& law, double t);

}  // namespace moivre
