// SPDX-License-Identifier: MIT
// Two continued fractions, expanded as long as they are one.
#include "moivre/numeric/simplest.h"

#include <algorithm>
#include <cmath>

#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

/// 0 < low <= high.
Rational simplest_between(const Rational& low, const Rational& high) {
  const Integer whole = numerator(low) / denominator(low);
  const Rational floor = ratio(whole);
  if (floor == low) return low;
  if (floor + Rational(1) <= high) return floor + Rational(1);
  return floor +
         Rational(1) / simplest_between(Rational(1) / (high - floor), Rational(1) / (low - floor));
}

}  // namespace

Rational simplest(double x, double error) {
  if (!std::isfinite(x) || !std::isfinite(error) || error < 0) {
    throw InvalidInput("a number and its error must be finite, the error not negative");
  }
  const Rational low = Rational(x) - Rational(error);
  const Rational high = Rational(x) + Rational(error);
  if (low <= Rational(0) && Rational(0) <= high) return {};
  return x > 0 ? simplest_between(low, high) : -simplest_between(-high, -low);
}

std::vector<Coefficient> simplest(const Point& x, double error) {
  std::vector<Coefficient> result;
  for (const Complex& xi : x) {
    const double within = error * std::max(1.0, std::abs(xi));
    result.push_back({simplest(xi.real(), within), simplest(xi.imag(), within)});
  }
  return result;
}

}  // namespace moivre
