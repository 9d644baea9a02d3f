// SPDX-License-Identifier: MIT
// Decimals of a fraction, from the factors 2 and 5 of its denominator.
#include "moivre/polynomial/digits.h"

#include <algorithm>
#include <cmath>

#include "moivre/numeric/integer.h"
#include "moivre/polynomial/double_range.h"
#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

// So many significant digits are nobody's choice: the number was computed, and rounded.
constexpr double kRoundedDigits = 10;
// Beside such numbers others are written without the zeros at their ends: one in a hundred has more
// than two.
constexpr double kZerosAtTheEnd = 2;
// Numbers of so many digits were computed in double.
constexpr double kDoubleDigits = 15;
constexpr double kMostDoubleDigits = 17;
// Bits behind the point that only a double has, and what a few operations in double lose.
constexpr std::size_t kDoubleBits = 40;
constexpr int kDoubleErrorLog2 = -49;

/// How often `factor` divides n, and what is left of n.
std::size_t take_out(Integer& n, int factor) {
  std::size_t count = 0;
  while (n % factor == 0) {
    n /= factor;
    ++count;
  }
  return count;
}

Rational half_unit(std::size_t decimals) {
  return ratio(1, 2 * boost::multiprecision::pow(Integer(10), static_cast<unsigned>(decimals)));
}

/// Half a unit of the last digit; 0 where the number is meant as it stands: it has fewer
/// significant digits than `least`.
Rational error_of(const Rational& a, double least) {
  if (a.is_zero()) return 0;
  Integer rest = denominator(a);
  const std::size_t twos = take_out(rest, 2);
  const std::size_t fives = take_out(rest, 5);
  const std::size_t decimals = std::max(twos, fives);
  if (rest != 1 || decimals == 0) return 0;
  const Rational as_double = times_power_of_two(abs(a), kDoubleErrorLog2);
  if (twos >= fives + kDoubleBits) return as_double;
  const double digits =
      log2_size(Coefficient{a, 0}) * std::log10(2.0) + static_cast<double>(decimals);
  if (digits < least - 1) return 0;
  if (digits < kRoundedDigits - 1) return half_unit(decimals + 1);
  const bool was_double = digits >= kDoubleDigits - 1 && digits < kMostDoubleDigits;
  return was_double ? std::max(half_unit(decimals), as_double) : half_unit(decimals);
}

double error_of(const Coefficient& c, double least) {
  double largest = 0;
  for (const Rational* part : {&c.re, &c.im}) {
    const Rational error = error_of(*part, least);
    if (!error.is_zero()) {
      largest = std::max(largest, std::exp2(log2_size(Coefficient{error, 0}) - log2_size(c)));
    }
  }
  return largest;
}

}  // namespace

bool is_rounded(const Rational& a) { return !error_of(a, kRoundedDigits).is_zero(); }

CoefficientErrors coefficient_errors(const System& f) {
  if (f.is_exact) return {};
  if (!f.scaled_log2.empty()) return coefficient_errors(as_typed(f));
  const auto are_rounded = [](const Polynomial& p) {
    return std::any_of(p.terms.begin(), p.terms.end(), [](const Term& term) {
      return error_of(term.coefficient, kRoundedDigits) > 0;
    });
  };
  if (std::none_of(f.polynomials.begin(), f.polynomials.end(), are_rounded)) return {};
  CoefficientErrors errors;
  std::uint32_t number = 0;
  for (const Polynomial& p : f.polynomials) {
    std::vector<NumberErrors>& own = errors.emplace_back();
    for (const Term& term : p.terms) {
      const double error = error_of(term.coefficient, kRoundedDigits - kZerosAtTheEnd);
      own.emplace_back();
      if (error > 0) own.back().push_back({number++, error});
    }
  }
  return errors;
}

}  // namespace moivre
