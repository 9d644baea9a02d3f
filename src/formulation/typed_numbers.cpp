// SPDX-License-Identifier: MIT
// Decimals of degrees, parabolas in exact numbers, and the errors of tables and formulas.
#include "typed_numbers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "moivre/mechanism/jet.h"
#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

// A decimal of so many digits is the only one that is rounded to its double.
constexpr int kSureDigits = 15;
// What a double is off by at most, relative to its size.
constexpr double kHalfUnit = 0x1p-53;

int digits_of(const Rational& decimal) {
  Integer digits = abs(numerator(decimal));
  // The denominator of a decimal divides a power of ten: brought to that, what is left are its
  // digits.
  Integer below = denominator(decimal);
  while (below != 1) {
    const Integer common = common_divisor(below, Integer(10));
    digits *= 10 / common;
    below /= common;
  }
  while (digits != 0 && digits % 10 == 0) digits /= 10;
  return static_cast<int>(digits.str().size());
}

/// Of the decimals that are rounded to it when multiplied by the unit the one with the fewest
/// digits.
ExactAngle degrees_of(double angle_rad) {
  constexpr double kDegree = std::numbers::pi / 180;
  constexpr int kNeighbours = 2;
  double near = angle_rad / kDegree;
  for (int k = 0; k < kNeighbours; ++k) near = std::nextafter(near, -HUGE_VAL);
  ExactAngle best{{}, Rational(angle_rad), kHalfUnit * std::abs(angle_rad)};
  int fewest = 0;
  for (int k = 0; k <= 2 * kNeighbours; ++k, near = std::nextafter(near, HUGE_VAL)) {
    if (near * kDegree != angle_rad) continue;
    const Rational degrees = typed_decimal(near);
    const int digits = digits_of(degrees);
    if (fewest != 0 && digits >= fewest) continue;
    fewest = digits;
    const double error = digits <= kSureDigits ? 0 : 4 * kHalfUnit * std::abs(angle_rad);
    best = {degrees, {}, error};
  }
  return best;
}

/// Where the law is none of exact numbers: how large what it was computed from is.
double size_of(const Spline& law, double) {
  double size = 0;
  for (const double value : law.value) size = std::max(size, std::abs(value));
  return size;
}

double size_of(const TypedLaw& law, double t) {
  return law.unit * evaluate<Magnitude>(law.formula, {}, Magnitude(t)).sum;
}

EnclosedNumber computed_value(const DriverLaw& law, double t) {
  const double value = driver_state(law, t).value;
  const auto* spline = std::get_if<Spline>(&law);
  const double size = spline ? size_of(*spline, t) : size_of(std::get<TypedLaw>(law), t);
  return {Rational(value), kComputed * std::max(size, std::abs(value))};
}

}  // namespace

ExactAngle typed_angle(double angle_rad, const Units& units) {
  if (angle_rad == 0) return {};
  if (units.angle == "deg") return degrees_of(angle_rad);
  return {{}, typed_decimal(angle_rad), 0};
}

EnclosedNumber typed(double number) { return {typed_decimal(number), 0}; }

EnclosedNumber computed_number(double value) {
  return {typed_decimal(value), kComputed * std::abs(value)};
}

ExactAngle plus(ExactAngle a, const ExactAngle& b) {
  a.degrees += b.degrees;
  a.radians += b.radians;
  a.error += b.error;
  return a;
}

ExactAngle times(const Rational& factor, ExactAngle angle) {
  angle.degrees *= factor;
  angle.radians *= factor;
  angle.error *= std::abs(to_double(factor));
  return angle;
}

ExactAngle computed_angle(double angle_rad) {
  return {{}, Rational(angle_rad), kComputed * std::max(1.0, std::abs(angle_rad))};
}

ExactAngle driven_angle(const DriverLaw& law, double t, const Units& units) {
  const auto* parabola = std::get_if<Parabola>(&law);
  if (parabola == nullptr) {
    const EnclosedNumber value = computed_value(law, t);
    return {{}, value.value, value.error};
  }
  const Rational time = typed_decimal(t);
  const ExactAngle speed = plus(typed_angle(parabola->velocity, units),
                                times(time / 2, typed_angle(parabola->acceleration, units)));
  return plus(typed_angle(parabola->start, units), times(time, speed));
}

EnclosedNumber driven_length(const DriverLaw& law, double t) {
  const auto* parabola = std::get_if<Parabola>(&law);
  if (parabola == nullptr) return computed_value(law, t);
  const Rational time = typed_decimal(t);
  const Rational speed =
      typed_decimal(parabola->velocity) + time / 2 * typed_decimal(parabola->acceleration);
  return {typed_decimal(parabola->start) + time * speed, 0};
}

}  // namespace moivre
