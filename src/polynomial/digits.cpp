// SPDX-License-Identifier: MIT
// Decimals of a fraction, from the factors 2 and 5 of its denominator.
#include "moivre/polynomial/digits.h"

#include <algorithm>
#include <cmath>

#include "moivre/numeric/integer.h"
#include "moivre/numeric/random.h"
#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

// So many significant digits are nobody's choice: the number was computed, and rounded.
constexpr double kRoundedDigits = 10;
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

/// Half a unit of the last digit; 0 where the number is meant as it stands.
Rational error_of(const Rational& a) {
  if (a.is_zero()) return 0;
  Integer rest = denominator(a);
  const std::size_t twos = take_out(rest, 2);
  const std::size_t fives = take_out(rest, 5);
  const std::size_t decimals = std::max(twos, fives);
  if (rest != 1 || decimals == 0) return 0;
  const Rational as_double = times_power_of_two(abs(a), kDoubleErrorLog2);
  if (fives == 0 && twos >= kDoubleBits) return as_double;
  const double digits = log2_size({a, 0}) * std::log10(2.0) + static_cast<double>(decimals);
  if (digits < kRoundedDigits - 1) return 0;
  const bool was_double = digits >= kDoubleDigits - 1 && digits < kMostDoubleDigits;
  return was_double ? std::max(half_unit(decimals), as_double) : half_unit(decimals);
}

}  // namespace

std::optional<System> other_reading(const System& f, std::uint64_t seed) {
  System other = f;
  std::uint64_t index = 0;
  bool is_other = false;
  for (Polynomial& p : other.polynomials) {
    for (Term& term : p.terms) {
      for (Rational* part : {&term.coefficient.re, &term.coefficient.im}) {
        const Rational error = error_of(*part);
        if (random_unit(seed, RandomStream::other_reading, index++) < 0.5) {
          *part += error;
        } else {
          *part -= error;
        }
        is_other = is_other || !error.is_zero();
      }
    }
  }
  return is_other ? std::optional(std::move(other)) : std::nullopt;
}

System differences(const System& f, const System& g) {
  System result = f;
  for (std::size_t i = 0; i < f.polynomials.size(); ++i) {
    for (std::size_t k = 0; k < f.polynomials[i].terms.size(); ++k) {
      Coefficient& c = result.polynomials[i].terms[k].coefficient;
      c = c - g.polynomials[i].terms[k].coefficient;
    }
  }
  return result;
}

bool has_terms_of(const System& f, const System& g) {
  const auto have_terms = [](const Polynomial& p, const Polynomial& q) {
    return std::equal(p.terms.begin(), p.terms.end(), q.terms.begin(), q.terms.end(),
                      [](const Term& a, const Term& b) { return a.monomial == b.monomial; });
  };
  return f.variables == g.variables &&
         std::equal(f.polynomials.begin(), f.polynomials.end(), g.polynomials.begin(),
                    g.polynomials.end(), have_terms);
}

}  // namespace moivre
