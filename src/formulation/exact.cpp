// SPDX-License-Identifier: MIT
// Exact numbers from doubles; the unit circle by its rational parametrization.
#include "moivre/formulation/exact.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numbers>
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

Coefficient unit_at(double phi) {
  constexpr double kQuarter = std::numbers::pi / 2;
  // Degrees turned to radians are rounded; a quarter turn is meant where nothing but that rounding is left.
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(phi));
  const double turns = std::nearbyint(phi / kQuarter);
  double rest = std::remainder(phi, kQuarter);
  if (std::abs(rest) <= rounding) rest = 0;
  const Rational tangent(std::tan(rest / 2));
  const Rational square = tangent * tangent;
  const Rational scale = 1 / (1 + square);
  Coefficient c{(1 - square) * scale, 2 * tangent * scale};
  switch (static_cast<int>(std::fmod(turns, 4.0) + 4) % 4) {
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

Coefficient exactly(Complex z) { return {Rational(z.real()), Rational(z.imag())}; }

Coefficient conjugate(const Coefficient& c) { return {c.re, -c.im}; }

}  // namespace moivre
