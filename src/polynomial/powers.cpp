// SPDX-License-Identifier: MIT
// Bases of powers, term by term from the highest one down.
#include "moivre/polynomial/powers.h"

#include <limits>
#include <numeric>
#include <optional>

#include "integer_polynomial.h"

namespace moivre {
namespace {

Monomial root_of(Monomial m, std::uint32_t exponent) {
  for (Power& power : m) power.exponent /= exponent;
  return m;
}

/// a / b; nullopt where b does not divide it.
std::optional<Monomial> quotient(const Monomial& a, const Monomial& b) {
  Monomial result;
  auto at = b.begin();
  for (const Power& power : a) {
    std::uint32_t exponent = power.exponent;
    if (at != b.end() && at->variable < power.variable) return std::nullopt;
    if (at != b.end() && at->variable == power.variable) {
      if (at->exponent > exponent) return std::nullopt;
      exponent -= at++->exponent;
    }
    if (exponent > 0) result.push_back({power.variable, exponent});
  }
  if (at != b.end()) return std::nullopt;
  return result;
}

Polynomial power(const Polynomial& base, std::uint32_t exponent) {
  Polynomial result = base;
  for (std::uint32_t e = 1; e < exponent; ++e) result = result * base;
  return result;
}

/// g with f = g^exponent, for f and g of leading coefficient 1.
///
/// Terms of g are found from the highest down: f - (g so far)^exponent begins with exponent * lt(g)^(exponent - 1) times the next one.
std::optional<Polynomial> base_of(const Polynomial& f, std::uint32_t exponent) {
  const Monomial& leading = f.terms.front().monomial;
  for (const Power& of_leading : leading) {
    if (of_leading.exponent % exponent != 0) return std::nullopt;
  }
  Polynomial g{{{{Rational(1), Rational(0)}, root_of(leading, exponent)}}};
  const Monomial divisor = power(g, exponent - 1).terms.front().monomial;
  const Coefficient share{Rational(1) / Rational(exponent), Rational(0)};
  const Coefficient minus_one{Rational(-1), Rational(0)};
  while (g.terms.size() <= f.terms.size()) {
    const Polynomial rest = f + minus_one * power(g, exponent);
    if (rest.terms.empty()) return g;
    const auto next = quotient(rest.terms.front().monomial, divisor);
    if (!next || !precedes(g.terms.back().monomial, *next)) return std::nullopt;
    g.terms.push_back({share * rest.terms.front().coefficient, *next});
  }
  return std::nullopt;
}

/// No other exponent than a divisor of this is possible.
std::uint32_t common_exponent(const Polynomial& f) {
  std::uint32_t common = 0;
  for (const Power& of_leading : f.terms.front().monomial) {
    common = std::gcd(common, of_leading.exponent);
  }
  return common;
}

struct PowerOf {
  Polynomial base;
  std::uint64_t exponent = 1;
};

/// f, not constant, as a power of a polynomial that is none.
PowerOf as_power(const Polynomial& f) {
  PowerOf result{f, 1};
  std::uint32_t left = common_exponent(f);
  if (left == 1) return result;
  const Coefficient one{Rational(1), Rational(0)};
  result.base = (one / f.terms.front().coefficient) * f;
  for (std::uint32_t prime = 2; prime <= left; ++prime) {
    for (; left % prime == 0; left /= prime) {
      auto base = base_of(result.base, prime);
      if (!base) continue;
      result = {std::move(*base), result.exponent * prime};
    }
  }
  return result;
}

}  // namespace

PowerFree power_free(const System& f) {
  PowerFree result{f, {}, 1};
  for (Polynomial& p : result.system.polynomials) {
    const PowerOf power = degree(p) > 0 ? as_power(p) : PowerOf{p, 1};
    const bool fits = result.sheets <= std::numeric_limits<std::uint64_t>::max() / power.exponent;
    result.exponents.push_back(fits ? power.exponent : 1);
    result.sheets *= result.exponents.back();
    if (result.exponents.back() > 1)
      p = to_polynomial(IntegerPolynomial{to_integer(power.base).terms});
  }
  return result;
}

}  // namespace moivre
