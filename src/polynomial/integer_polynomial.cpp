// SPDX-License-Identifier: MIT
// Arithmetic of polynomials with Gaussian integer coefficients and one exact factor outside.
#include "integer_polynomial.h"

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

/// A size and its error.
struct Rough {
  double size = 0;
  double error = 0;
};
using RoughTerms = std::map<Monomial, Rough, MonomialOrder>;

void add_to(RoughTerms& sum, const Monomial& m, const Rough& c) {
  Rough& at = sum[m];
  at.size += c.size;
  at.error += c.error;
}

RoughTerms operator*(const RoughTerms& a, const RoughTerms& b) {
  RoughTerms result;
  for (const auto& [m, c] : a) {
    for (const auto& [n, d] : b) {
      add_to(result, product(m, n), {c.size * d.size, c.size * d.error + c.error * d.size});
    }
  }
  return result;
}

RoughTerms rough(const IntegerTerms& terms, double unit, const TermErrors& errors) {
  RoughTerms result;
  for (const auto& [m, c] : terms) {
    result[m].size = unit * std::exp2(log2_size(Coefficient{ratio(c.re), ratio(c.im)}));
  }
  for (const auto& [m, error] : errors) result[m].error = error;
  return result;
}

/// Horner, as for the terms themselves.
TermErrors errors_of_substituted(const IntegerPolynomial& p, const AffineForm& form) {
  if (p.errors.empty() && form.errors.empty()) return {};
  std::map<std::uint32_t, RoughTerms> by_exponent;
  for (const auto& [m, c] : rough(p.terms, std::exp2(log2_size(p.factor)), p.errors)) {
    by_exponent[exponent_of(m, form.variable)].emplace(without_variable(m, form.variable), c);
  }
  const double unit = std::exp2(-log2_size(Coefficient{ratio(form.divisor), 0}));
  const RoughTerms value = rough(form.terms, unit, form.errors);
  RoughTerms sum;
  for (std::uint32_t e = by_exponent.rbegin()->first + 1; e-- > 0;) {
    sum = sum * value;
    for (const auto& [m, c] : by_exponent[e]) add_to(sum, m, c);
  }
  TermErrors errors;
  for (const auto& [m, c] : sum) {
    if (c.error > 0) errors[m] = c.error;
  }
  return errors;
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
  const auto error_at = [&m](const IntegerPolynomial& q) {
    const auto found = q.errors.find(m);
    return found == q.errors.end() ? 0 : found->second;
  };
  // Where the coefficients of m are others, so is the multiple that removes it.
  const double size = size_of(pivot, pivot.terms.at(m));
  const double share = size_of(p, at->second) / size;
  const double error_of_share = (error_at(p) + share * error_at(pivot)) / size;
  for (const auto& [n, error] : pivot.errors) result.errors[n] += share * error;
  result.errors.erase(m);
  if (error_of_share == 0) return result;
  for (const auto& [n, c] : pivot.terms) {
    if (n != m) result.errors[n] += error_of_share * size_of(pivot, c);
  }
  return result;
}

double size_of(const IntegerPolynomial& p, const GaussianInteger& c) {
  return std::exp2(log2_size(p.factor) + log2_size(Coefficient{ratio(c.re), ratio(c.im)}));
}

AffineForm form_of(const IntegerPolynomial& linear, std::uint32_t variable) {
  const Monomial unknown{{variable, 1}};
  AffineForm form{variable, linear.terms, linear.terms.at(unknown).re, {}};
  form.terms.erase(unknown);
  for (auto& [m, c] : form.terms) c = -c;
  if (linear.errors.empty()) return form;
  const double size = size_of(linear, linear.terms.at(unknown));
  for (const auto& [m, error] : linear.errors) {
    if (m != unknown) form.errors[m] = error / size;
  }
  const auto of_unknown = linear.errors.find(unknown);
  if (of_unknown == linear.errors.end()) return form;
  for (const auto& [m, c] : form.terms) {
    form.errors[m] += size_of(linear, c) / size * (of_unknown->second / size);
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
