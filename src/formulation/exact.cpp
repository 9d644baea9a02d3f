// SPDX-License-Identifier: MIT
// Exact numbers from doubles; the unit circle by its rational parametrization.
#include "moivre/formulation/exact.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

Rational power_of_ten(int exponent) {
  constexpr int kWord = 18;  // 10^18 < 2^63
  const int size = std::abs(exponent);
  if (size > kWord) {
    const Integer power = pow(Integer(10), static_cast<unsigned>(size));
    return exponent < 0 ? ratio(1, power) : ratio(power);
  }
  std::int64_t power = 1;
  for (int k = 0; k < size; ++k) power *= 10;
  return exponent < 0 ? Rational(1, power) : Rational(power);
}

// A fixed-point number of so many bits behind the point holds an angle, its cosine and its sine; of
// a half angle's tangent fewer are kept.
constexpr unsigned kWorkingBits = 192;
constexpr unsigned kTangentBits = 128;
// A product of directions is rounded to one of kTangentBits where it has become as long as this.
constexpr std::size_t kLongUnit = 640;

const Rational kPi =
    ratio(Integer("31415926535897932384626433832795028841971693993751058209749445923078164062862"),
          pow(Integer(10), 76));

Integer rounded_ratio(const Integer& above, const Integer& below) {
  const Integer twice = 2 * above + below;
  Integer quotient = twice / (2 * below);
  if (twice < 0 && quotient * 2 * below != twice) --quotient;
  return quotient;
}

Integer fixed(const Rational& x) {
  return rounded_ratio(numerator(x) << kWorkingBits, denominator(x));
}

bool is_whole_number(const Rational& x) { return denominator(x) == 1; }

/// tan(r / 2) of an angle of at most an eighth of a turn, by the series of its cosine and sine:
/// some forty terms, each right to two of the last of kWorkingBits.
Rational half_tangent(const Integer& r) {
  const Integer one = Integer(1) << kWorkingBits;
  const Integer angle = abs(r);
  Integer cosine = 0;
  Integer sine = 0;
  Integer term = one;
  for (unsigned k = 0; term != 0;) {
    Integer& sum = k % 2 == 0 ? cosine : sine;
    if (k % 4 < 2) {
      sum += term;
    } else {
      sum -= term;
    }
    term *= angle;
    term >>= kWorkingBits;
    term /= ++k;
  }
  if (r < 0) sine = -sine;
  return ratio(rounded_ratio(sine << kTangentBits, one + cosine), Integer(1) << kTangentBits);
}

Coefficient on_circle(const Rational& tangent) {
  const Rational square = tangent * tangent;
  const Rational scale = 1 / (1 + square);
  return {(1 - square) * scale, 2 * tangent * scale};
}

Coefficient turned_by_quarters(const Coefficient& c, int quarters) {
  switch (quarters) {
    case 1:
      return {-c.im, c.re};
    case 2:
      return {-c.re, -c.im};
    case 3:
      return {c.im, -c.re};
    default:
      return c;
  }
}

EnclosedUnit shortened(EnclosedUnit unit) {
  if (std::max(bit_length(unit.value.re), bit_length(unit.value.im)) <= kLongUnit) return unit;
  int quarters = 0;
  while (unit.value.re < abs(unit.value.im)) {
    unit.value = turned_by_quarters(unit.value, 1);
    ++quarters;
  }
  const Rational tangent = unit.value.im / (1 + unit.value.re);
  const Integer rounded = rounded_ratio(numerator(tangent) << kTangentBits, denominator(tangent));
  const Coefficient near = on_circle(ratio(rounded, Integer(1) << kTangentBits));
  return {turned_by_quarters(near, (4 - quarters % 4) % 4), unit.error + kUnitError};
}

}  // namespace

// The shortest decimal of a double has up to 17 digits: they fit a word.
Rational typed_decimal(double x) {
  if (!std::isfinite(x)) throw InvalidInput("no decimal was typed for " + std::to_string(x));
  constexpr std::size_t kLongestDouble = 32;
  char text[kLongestDouble];
  const char* const end =
      std::to_chars(text, text + sizeof text, std::abs(x), std::chars_format::scientific).ptr;
  std::int64_t digits = 0;
  int decimals = 0;
  const char* place = text;
  for (bool is_behind_dot = false; *place != 'e'; ++place) {
    if (*place == '.') {
      is_behind_dot = true;
      continue;
    }
    digits = 10 * digits + (*place - '0');
    if (is_behind_dot) ++decimals;
  }
  place += place[1] == '+' ? 2 : 1;
  int exponent = 0;
  std::from_chars(place, end, exponent);
  return Rational(x < 0 ? -digits : digits) * power_of_ten(exponent - decimals);
}

Coefficient typed_decimal(double x, double y) { return {typed_decimal(x), typed_decimal(y)}; }

Rational signed_square(double length) {
  return typed_decimal(length) * typed_decimal(std::abs(length));
}

EnclosedUnit unit_at(const ExactAngle& phi) {
  const Integer quarter = fixed(kPi / 2);
  const Integer total = fixed(phi.degrees * kPi / 180 + phi.radians);
  const Integer turns = rounded_ratio(total, quarter);
  Integer rest = total - turns * quarter;
  const double left = to_double(ratio(abs(rest), Integer(1) << kWorkingBits));
  const double size = to_double(ratio(abs(total), Integer(1) << kWorkingBits));
  // Radians of a quarter turn are rounded; one is meant where nothing but that rounding is left.
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::max(1.0, size);
  const bool is_typed_exactly = phi.radians.is_zero() && phi.error == 0;
  const bool is_whole = is_typed_exactly && is_whole_number(phi.degrees / 90);
  double error = phi.error;
  if (is_whole || (!is_typed_exactly && left <= rounding)) {
    if (!is_whole) error += left;
    rest = 0;
  } else {
    error += kUnitError;
  }
  const int quarters = static_cast<int>((turns % 4 + 4) % 4);
  return {turned_by_quarters(on_circle(half_tangent(rest)), quarters), error};
}

EnclosedUnit operator*(const EnclosedUnit& a, const EnclosedUnit& b) {
  return shortened({a.value * b.value, a.error + b.error + a.error * b.error});
}

EnclosedUnit conjugate(const EnclosedUnit& a) { return {conjugate(a.value), a.error}; }

Coefficient exactly(Complex z) { return {Rational(z.real()), Rational(z.imag())}; }

Coefficient conjugate(const Coefficient& c) { return {c.re, -c.im}; }

}  // namespace moivre
