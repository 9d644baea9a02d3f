// SPDX-License-Identifier: MIT
// Bases of powers, term by term from the highest one down.
#include "moivre/polynomial/powers.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "moivre/polynomial/double_range.h"
#include "moivre/polynomial/integer_polynomial.h"
#include "moivre/polynomial/modular_line.h"

namespace moivre {
namespace {

// Products of terms while the base of one equation is looked for; a few seconds.
constexpr std::size_t kMostWork = 4'000'000;
// Equations of a higher degree are looked at no further.
constexpr std::uint64_t kHighestDegree = 4096;
// Whatever its prime divides, a line of a power is one: bases are looked for in vain at worst.
constexpr PrimeField kField;

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

/// p(s) from its values at s = 0, 1, ..., by divided differences.
Line interpolated(std::vector<Residue> values) {
  const std::size_t n = values.size();
  for (std::size_t level = 1; level < n; ++level) {
    const Residue over = kField.inverse(level);
    for (std::size_t k = n; k-- > level;) {
      values[k] = kField.times(kField.plus(values[k], kField.minus(values[k - 1])), over);
    }
  }
  Line p{values[n - 1]};
  for (std::size_t k = n - 1; k-- > 0;) {
    p.push_back(0);
    for (std::size_t j = p.size(); j-- > 1;)
      p[j] = kField.plus(p[j - 1], kField.times(kField.minus(k), p[j]));
    p[0] = kField.plus(kField.times(kField.minus(k), p[0]), values[k]);
  }
  trim(p);
  return p;
}

/// f on the line of points (a_v + b_v s).
Line on_a_line(const Polynomial& f) {
  constexpr Residue kOffset = 1'000'003;
  constexpr Residue kSlope = 777'767'777;
  const IntegerPolynomial whole = to_integer(f);
  std::vector<Residue> values;
  for (Residue s = 0; s <= degree(f); ++s) {
    Residue value = 0;
    for (const auto& [monomial, coefficient] : whole.terms) {
      Residue product = kField.residue(coefficient);
      for (const Power& factor : monomial) {
        const Residue v = factor.variable + 1;
        const Residue x = kField.plus(kField.times(kOffset, kField.times(v, v)),
                                      kField.times(kField.plus(kSlope, v), s));
        product = kField.times(product, kField.power(x, factor.exponent));
      }
      value = kField.plus(value, product);
    }
    values.push_back(value);
  }
  return interpolated(std::move(values));
}

/// f is no higher power than this: a power of e has deg f / e different points on a line at most.
/// Nearly always 1 if f is none.
std::uint64_t most_exponent(const Polynomial& f) {
  const Line p = on_a_line(f);
  if (p.size() < 2) return 1;
  const std::size_t d = p.size() - 1;
  return d / (d - degree_of_gcd(kField, p, derivative(kField, p)));
}

/// g with f = g^exponent, for f and g of leading coefficient 1.
///
/// Terms of g are found from the highest down: f - (g so far)^exponent begins with exponent *
/// lt(g)^(exponent - 1) times the next one.
std::optional<Polynomial> base_of(const Polynomial& f, std::uint32_t exponent) {
  const Monomial& leading = f.terms.front().monomial;
  Polynomial g{{{{Rational(1), Rational(0)}, root_of(leading, exponent)}}};
  const Monomial divisor = power(g, exponent - 1).terms.front().monomial;
  const Coefficient share{Rational(1) / Rational(exponent), Rational(0)};
  const Coefficient minus_one{Rational(-1), Rational(0)};
  for (std::size_t work = 0; work <= kMostWork; work += f.terms.size() * g.terms.size()) {
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

/// f, not constant, as the highest power.
PowerOf as_power(const Polynomial& f) {
  const std::uint32_t common = common_exponent(f);
  if (common == 1 || degree(f) > kHighestDegree) return {f, 1};
  const Coefficient one{Rational(1), Rational(0)};
  const Polynomial monic = (one / f.terms.front().coefficient) * f;
  const std::uint64_t most = most_exponent(monic);
  for (auto e = static_cast<std::uint32_t>(std::min<std::uint64_t>(most, common)); e > 1; --e) {
    if (common % e != 0) continue;
    auto base = base_of(monic, e);
    if (base && log2_into_double(*base)) return {std::move(*base), e};
  }
  return {f, 1};
}

}  // namespace

PowerFree power_free(const System& f) {
  PowerFree result{f, {}, 1};
  std::vector<int>& scaled = result.system.scaled_log2;
  for (Polynomial& p : result.system.polynomials) {
    const PowerOf power = degree(p) > 0 ? as_power(p) : PowerOf{p, 1};
    const bool fits = result.sheets <= std::numeric_limits<std::uint64_t>::max() / power.exponent;
    result.exponents.push_back(fits ? power.exponent : 1);
    result.sheets *= result.exponents.back();
    if (result.exponents.back() == 1) continue;
    const Polynomial base = to_polynomial(IntegerPolynomial{to_integer(power.base).terms});
    scaled.resize(f.polynomials.size());
    scaled[result.exponents.size() - 1] = log2_into_double(base).value_or(0);
    p = times_power_of_two(base, scaled[result.exponents.size() - 1]);
  }
  return result;
}

}  // namespace moivre
