// SPDX-License-Identifier: MIT
// Arithmetic of polynomials with Gaussian integer coefficients and one exact factor outside.
#include "moivre/polynomial/integer_polynomial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "moivre/polynomial/scale.h"

namespace moivre {
namespace {

void add_to(IntegerTerms& sum, const Monomial& m, const GaussianInteger& c) {
  const auto [at, is_new] = sum.try_emplace(m, c);
  if (is_new) return;
  at->second.re += c.re;
  at->second.im += c.im;
  if (is_zero(at->second)) sum.erase(at);
}

IntegerTerms operator*(const IntegerTerms& a, const IntegerTerms& b) {
  IntegerTerms result;
  for (const auto& [m, c] : a) {
    for (const auto& [n, d] : b) add_to(result, product(m, n), c * d);
  }
  return result;
}

Monomial without_variable(const Monomial& m, std::uint32_t variable) {
  Monomial rest;
  for (const Power& p : m) {
    if (p.variable != variable) rest.push_back(p);
  }
  return rest;
}

/// Multiplies the terms so that the coefficient of `m` is a positive integer.
void make_real(IntegerPolynomial& p, const Monomial& m) {
  const GaussianInteger& c = p.terms.at(m);
  const GaussianInteger multiplier =
      c.im.is_zero() ? GaussianInteger{c.re < 0 ? -1 : 1, 0} : conjugate(c);
  for (auto& [n, d] : p.terms) d = d * multiplier;
  p.factor = p.factor / Coefficient{ratio(multiplier.re), ratio(multiplier.im)};
}

void remove_common_divisor(IntegerPolynomial& p) {
  Integer divisor = 0;
  for (const auto& [m, c] : p.terms) {
    divisor = common_divisor(divisor, c.re);
    divisor = common_divisor(divisor, c.im);
    if (divisor == 1) return;
  }
  if (divisor.is_zero()) return;
  for (auto& [m, c] : p.terms) {
    c.re /= divisor;
    c.im /= divisor;
  }
  p.factor = p.factor * Coefficient{ratio(divisor), 0};
}

/// A coefficient in double and its errors.
struct Rounded {
  Complex value;
  NumberErrors errors;
};
using RoundedTerms = std::map<Monomial, Rounded, MonomialOrder>;

RoundedTerms operator*(const RoundedTerms& a, const RoundedTerms& b) {
  RoundedTerms result;
  for (const auto& [m, c] : a) {
    for (const auto& [n, d] : b) {
      Rounded& at = result[product(m, n)];
      at.value += c.value * d.value;
      add(at.errors, c.value, d.errors);
      add(at.errors, d.value, c.errors);
    }
  }
  return result;
}

RoundedTerms rounded(const IntegerTerms& terms, const Coefficient& factor,
                     const TermErrors& errors) {
  RoundedTerms result;
  for (const auto& [m, c] : terms) {
    result[m].value = to_complex(factor * Coefficient{ratio(c.re), ratio(c.im)});
  }
  for (const auto& [m, error] : errors) result[m].errors = error;
  return result;
}

/// Horner, as for the terms themselves.
TermErrors errors_of_substituted(const IntegerPolynomial& p, const AffineForm& form) {
  if (p.errors.empty() && form.errors.empty()) return {};
  std::map<std::uint32_t, RoundedTerms> by_exponent;
  for (const auto& [m, c] : rounded(p.terms, p.factor, p.errors)) {
    by_exponent[exponent_of(m, form.variable)].emplace(without_variable(m, form.variable), c);
  }
  const RoundedTerms value = rounded(form.terms, {ratio(1, form.divisor), 0}, form.errors);
  RoundedTerms sum;
  for (std::uint32_t e = by_exponent.rbegin()->first + 1; e-- > 0;) {
    sum = sum * value;
    for (const auto& [m, c] : by_exponent[e]) {
      sum[m].value += c.value;
      add(sum[m].errors, 1, c.errors);
    }
  }
  TermErrors errors;
  for (auto& [m, c] : sum) {
    if (!c.errors.empty()) errors[m] = std::move(c.errors);
  }
  return errors;
}

const NumberErrors& errors_at(const TermErrors& errors, const Monomial& m) {
  static const NumberErrors exact;
  const auto found = errors.find(m);
  return found == errors.end() ? exact : found->second;
}

}  // namespace

bool is_zero(const GaussianInteger& a) { return a.re.is_zero() && a.im.is_zero(); }

GaussianInteger operator*(const GaussianInteger& a, const GaussianInteger& b) {
  if (a.im.is_zero() && b.im.is_zero()) return {a.re * b.re, 0};
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

GaussianInteger operator-(const GaussianInteger& a) { return {-a.re, -a.im}; }

GaussianInteger conjugate(const GaussianInteger& a) { return {a.re, -a.im}; }

IntegerPolynomial to_integer(const Polynomial& p) {
  Integer common = 1;
  for (const Term& term : p.terms) {
    for (const Rational* part : {&term.coefficient.re, &term.coefficient.im}) {
      common *= denominator(*part) / common_divisor(common, denominator(*part));
    }
  }
  const auto scaled = [&common](const Rational& a) {
    return Integer(numerator(a) * (common / denominator(a)));
  };
  IntegerPolynomial result;
  for (const Term& term : p.terms) {
    result.terms.emplace(term.monomial,
                         GaussianInteger{scaled(term.coefficient.re), scaled(term.coefficient.im)});
  }
  result.factor = {ratio(1, common), 0};
  make_primitive(result);
  return result;
}

Polynomial to_polynomial(const IntegerPolynomial& p) {
  Polynomial result;
  for (const auto& [m, c] : p.terms) {
    result.terms.push_back({p.factor * Coefficient{ratio(c.re), ratio(c.im)}, m});
  }
  return result;
}

std::uint64_t degree(const IntegerPolynomial& p) {
  return p.terms.empty() ? 0 : degree(p.terms.begin()->first);
}

void make_primitive(IntegerPolynomial& p) {
  const bool all_real = std::all_of(p.terms.begin(), p.terms.end(),
                                    [](const auto& term) { return term.second.im.is_zero(); });
  if (!all_real) make_real(p, p.terms.begin()->first);
  remove_common_divisor(p);
}

IntegerPolynomial with_real_coefficient(const IntegerPolynomial& p, const Monomial& m) {
  IntegerPolynomial result = p;
  make_real(result, m);
  remove_common_divisor(result);
  return result;
}

IntegerPolynomial without_monomial(const IntegerPolynomial& p, const IntegerPolynomial& pivot,
                                   const Monomial& m) {
  const auto at = p.terms.find(m);
  if (at == p.terms.end()) return p;
  const Integer& leading = pivot.terms.at(m).re;
  const GaussianInteger multiplier = -at->second;
  IntegerPolynomial result = p;
  for (auto& [n, c] : result.terms) {
    c.re *= leading;
    c.im *= leading;
  }
  for (const auto& [n, c] : pivot.terms) add_to(result.terms, n, multiplier * c);
  result.factor = result.factor / Coefficient{ratio(leading), 0};
  make_primitive(result);
  if (p.errors.empty() && pivot.errors.empty()) return result;
  // Where the coefficients of m are others, so is the multiple that removes it.
  const Complex divisor = value_of(pivot, pivot.terms.at(m));
  const Complex share = value_of(p, at->second) / divisor;
  NumberErrors of_share;
  add(of_share, 1.0 / divisor, errors_at(p.errors, m));
  add(of_share, -share / divisor, errors_at(pivot.errors, m));
  for (const auto& [n, errors] : pivot.errors) add(result.errors[n], -share, errors);
  result.errors.erase(m);
  if (of_share.empty()) return result;
  for (const auto& [n, c] : pivot.terms) {
    if (n != m) add(result.errors[n], -value_of(pivot, c), of_share);
  }
  return result;
}

Complex value_of(const IntegerPolynomial& p, const GaussianInteger& c) {
  return to_complex(p.factor * Coefficient{ratio(c.re), ratio(c.im)});
}

AffineForm form_of(const IntegerPolynomial& linear, std::uint32_t variable) {
  const Monomial unknown{{variable, 1}};
  AffineForm form{variable, linear.terms, linear.terms.at(unknown).re, {}};
  form.terms.erase(unknown);
  for (auto& [m, c] : form.terms) c = -c;
  if (linear.errors.empty()) return form;
  const Complex divisor = value_of(linear, linear.terms.at(unknown));
  for (const auto& [m, errors] : linear.errors) {
    if (m != unknown) add(form.errors[m], -1.0 / divisor, errors);
  }
  const NumberErrors& of_unknown = errors_at(linear.errors, unknown);
  if (of_unknown.empty()) return form;
  for (const auto& [m, c] : linear.terms) {
    if (m != unknown) add(form.errors[m], value_of(linear, c) / divisor / divisor, of_unknown);
  }
  return form;
}

IntegerPolynomial substituted(const IntegerPolynomial& p, const AffineForm& form) {
  std::map<std::uint32_t, IntegerTerms> by_exponent;
  std::uint32_t highest = 0;
  for (const auto& [m, c] : p.terms) {
    const std::uint32_t e = exponent_of(m, form.variable);
    by_exponent[e].emplace(without_variable(m, form.variable), c);
    highest = std::max(highest, e);
  }
  if (highest == 0) return p;

  // Horner in form/divisor: after the step for exponent e the sum is divisor^(highest - e) times
  // the true one.
  IntegerPolynomial result;
  Integer power = 1;
  for (std::uint32_t e = highest + 1; e-- > 0;) {
    if (e < highest) {
      result.terms = result.terms * form.terms;
      power *= form.divisor;
    }
    for (const auto& [m, c] : by_exponent[e]) {
      add_to(result.terms, m, {c.re * power, c.im * power});
    }
  }
  result.factor = p.factor / Coefficient{ratio(power), 0};
  result.errors = errors_of_substituted(p, form);
  make_primitive(result);
  return result;
}

std::uint32_t exponent_of(const Monomial& m, std::uint32_t variable) {
  for (const Power& p : m) {
    if (p.variable == variable) return p.exponent;
  }
  return 0;
}

std::size_t bit_length(const IntegerPolynomial& p) {
  std::size_t longest = std::max(bit_length(p.factor.re), bit_length(p.factor.im));
  for (const auto& [m, c] : p.terms)
    longest = std::max({longest, bit_length(c.re), bit_length(c.im)});
  return longest;
}

}  // namespace moivre
