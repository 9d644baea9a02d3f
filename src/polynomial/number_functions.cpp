// SPDX-License-Identifier: MIT
// The functions in binary floating point of 50 digits, rounded to 40.
#include "number_functions.h"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <map>

#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

using Float = boost::multiprecision::cpp_bin_float_50;

constexpr int kDigits = 40;

// Units of the last digit, different for different numbers: sqrt(8) - 2*sqrt(2) shows.
constexpr int kLeastNudge = 100, kNudges = 900;

thread_local bool is_nudged = false;

Float to_float(const Rational& x) { return Float(numerator(x)) / Float(denominator(x)); }

/// nullopt where x is no number, or beyond double.
std::optional<Rational> rounded_to_digits(const Float& x) {
  if (!isfinite(x) || abs(x) > Float(1e300)) return std::nullopt;
  if (x == 0) return Rational(0);
  if (abs(x) < Float(1e-300)) return std::nullopt;
  const int exponent = kDigits - 1 - static_cast<int>(floor(log10(abs(x))));
  const Integer ten = 10;
  const auto power = static_cast<unsigned>(exponent < 0 ? -exponent : exponent);
  const Integer scale = pow(ten, power);
  const Float scaled = exponent < 0 ? x / Float(scale) : x * Float(scale);
  auto digits = static_cast<Integer>(round(scaled));
  if (is_nudged) digits += kLeastNudge + static_cast<int>(digits % kNudges);
  return exponent < 0 ? ratio(digits * scale, 1) : ratio(digits, scale);
}

/// Beyond it too few of the 50 digits are left of an angle.
bool is_small_angle(const Rational& x) { return abs(x) <= Rational(1000000); }

template <class Function>
std::optional<Rational> at(const Rational& x, const Function& function) {
  return rounded_to_digits(function(to_float(x)));
}

/// The root itself where it is a fraction.
std::optional<Rational> exact_square_root(const Rational& x) {
  if (x < 0) return std::nullopt;
  const Integer above = sqrt(numerator(x));
  const Integer below = sqrt(denominator(x));
  if (above * above != numerator(x) || below * below != denominator(x)) return std::nullopt;
  return ratio(above, below);
}

std::optional<Rational> square_root(const Rational& x) {
  if (x < 0) return std::nullopt;
  if (auto exact = exact_square_root(x)) return exact;
  return at(x, [](const Float& f) { return Float(sqrt(f)); });
}

std::optional<Rational> cube_root(const Rational& x) { return number_power(x, Rational(1, 3)); }

}  // namespace

NumberFunction number_function(const std::string& name) {
  static const std::map<std::string, NumberFunction> functions{
      {"sqrt", square_root},
      {"cbrt", cube_root},
      {"exp",
       [](const Rational& x) { return at(x, [](const Float& f) { return Float(exp(f)); }); }},
      {"log",
       [](const Rational& x) {
         return x > 0 ? at(x, [](const Float& f) { return Float(log(f)); }) : std::nullopt;
       }},
      {"sin",
       [](const Rational& x) {
         return is_small_angle(x) ? at(x, [](const Float& f) { return Float(sin(f)); })
                                  : std::nullopt;
       }},
      {"cos",
       [](const Rational& x) {
         return is_small_angle(x) ? at(x, [](const Float& f) { return Float(cos(f)); })
                                  : std::nullopt;
       }},
      {"tan",
       [](const Rational& x) {
         return is_small_angle(x) ? at(x, [](const Float& f) { return Float(tan(f)); })
                                  : std::nullopt;
       }},
      {"asin",
       [](const Rational& x) { return at(x, [](const Float& f) { return Float(asin(f)); }); }},
      {"acos",
       [](const Rational& x) { return at(x, [](const Float& f) { return Float(acos(f)); }); }},
      {"atan",
       [](const Rational& x) { return at(x, [](const Float& f) { return Float(atan(f)); }); }},
  };
  const auto found = functions.find(name);
  return found == functions.end() ? nullptr : found->second;
}

std::optional<Rational> number_power(const Rational& base, const Rational& exponent) {
  if (exponent == Rational(1, 2)) return square_root(base);
  if (base.is_zero()) return exponent > 0 ? std::optional(Rational(0)) : std::nullopt;
  // (-8)^(1/3) is -2 to some and complex to others.
  if (base < 0) return std::nullopt;
  const Float power = to_float(exponent);
  return at(base, [&](const Float& f) { return Float(pow(f, power)); });
}

Rational number_pi() { return *rounded_to_digits(boost::math::constants::pi<Float>()); }

NudgedNumbers::NudgedNumbers() { is_nudged = true; }
NudgedNumbers::~NudgedNumbers() { is_nudged = false; }

}  // namespace moivre
