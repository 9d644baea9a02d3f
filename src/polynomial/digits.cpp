// SPDX-License-Identifier: MIT
// Decimals of a fraction, from the factors 2 and 5 of its denominator.
#include "moivre/polynomial/digits.h"

#include <algorithm>
#include <cmath>

#include "moivre/numeric/integer.h"
#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

// So many significant digits are nobody's choice: the number was computed, and rounded.
constexpr double kRoundedDigits = 10;
// From here on it was computed in double.
constexpr double kDoubleDigits = 15;
constexpr double kMostDoubleDigits = 17;
// Bits behind the point that only a double has, and what a few operations in double lose.
constexpr std::size_t kDoubleBits = 40;
const double kDoubleError = std::exp2(-49);

/// How often `factor` divides n, and what is left of n.
std::size_t take_out(Integer& n, int factor) {
  std::size_t count = 0;
  while (n % factor == 0) {
    n /= factor;
    ++count;
  }
  return count;
}

/// Absolute.
double error_of(const Rational& a) {
  if (a.is_zero()) return 0;
  Integer rest = denominator(a);
  const std::size_t twos = take_out(rest, 2);
  const std::size_t fives = take_out(rest, 5);
  const std::size_t decimals = std::max(twos, fives);
  if (rest != 1 || decimals == 0) return 0;
  const double log10_size = log2_size({a, 0}) * std::log10(2.0);
  const double size = std::pow(10.0, log10_size);
  if (fives == 0 && twos >= kDoubleBits) return kDoubleError * size;
  const double digits = log10_size + static_cast<double>(decimals);
  if (digits < kRoundedDigits - 1) return 0;
  const double half_unit = 0.5 * std::pow(10.0, -static_cast<double>(decimals));
  const bool was_double = digits >= kDoubleDigits - 1 && digits < kMostDoubleDigits;
  return was_double ? std::max(half_unit, kDoubleError * size) : half_unit;
}

}  // namespace

double coefficient_error(const System& f) {
  double largest = 0;
  for (const Polynomial& p : f.polynomials) {
    for (const Term& term : p.terms) {
      const double error = std::hypot(error_of(term.coefficient.re), error_of(term.coefficient.im));
      if (error == 0) continue;
      largest = std::max(largest, error / std::exp2(log2_size(term.coefficient)));
    }
  }
  return largest;
}

}  // namespace moivre
