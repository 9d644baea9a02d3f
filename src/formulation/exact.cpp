// SPDX-License-Identifier: MIT
// Exact numbers from doubles; the unit circle by its rational parametrisation.
#include "moivre/formulation/exact.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

Rational power_of_ten(int exponent) {
  const Integer power = pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? ratio(1, power) : ratio(power);
}

}  // namespace

Rational typed_decimal(double x) {
  constexpr std::size_t kLongestDouble = 32;
  char text[kLongestDouble];
  const auto end = std::to_chars(text, text + sizeof text, x, std::chars_format::scientific);
  const std::string all(text, end.ptr);
  const std::size_t e = all.find('e');
  const std::size_t dot = all.find('.');
  std::string digits = all.substr(0, e);
  int exponent = std::stoi(all.substr(e + 1));
  if (dot < e) {
    exponent -= static_cast<int>(e - dot - 1);
    digits.erase(dot, 1);
  }
  // Leading zeros would be read as an octal number.
  const bool is_negative = digits.front() == '-';
  const std::size_t first = digits.find_first_of("123456789");
  if (first == std::string::npos) return Rational(0);
  const Rational value = ratio(Integer(digits.substr(first))) * power_of_ten(exponent);
  return is_negative ? -value : value;
}

Coefficient typed_decimal(double x, double y) { return {typed_decimal(x), typed_decimal(y)}; }

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
