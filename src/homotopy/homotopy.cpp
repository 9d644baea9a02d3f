// SPDX-License-Identifier: MIT
// One support for all t, the union of what both ends have, and the coefficients at both ends.
#include "moivre/homotopy/homotopy.h"

#include <algorithm>

#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/homogenize.h"
#include "moivre/polynomial/scale.h"
#include "moivre/polynomial/value.h"

namespace moivre {
namespace {

void require_square_pair(const System& f, const System& g) {
  const std::size_t n = f.variables.size();
  if (f.polynomials.size() == n && g.variables.size() == n && g.polynomials.size() == n) return;
  throw InvalidInput("a homotopy needs two systems of n polynomials in n variables; got " +
                     std::to_string(f.polynomials.size()) + " in " + std::to_string(n) + " and " +
                     std::to_string(g.polynomials.size()) + " in " +
                     std::to_string(g.variables.size()));
}

/// The terms of both, with coefficient 1.
Polynomial united(const Polynomial& a, const Polynomial& b) {
  TermMap terms;
  for (const Polynomial* p : {&a, &b}) {
    for (const Term& term : p->terms) terms[term.monomial] = Coefficient{1, 0};
  }
  return to_polynomial(terms);
}

/// The coefficient of each term of `support` in p, zero where p has none.
void append_coefficients(const Polynomial& support, const Polynomial& p,
                         std::vector<Coefficient>& c) {
  auto own = p.terms.begin();
  for (const Term& term : support.terms) {
    const bool has_it = own != p.terms.end() && own->monomial == term.monomial;
    c.push_back(has_it ? (own++)->coefficient : Coefficient{});
  }
}

Coefficient exactly(const Complex& x) { return {Rational(x.real()), Rational(x.imag())}; }

/// The derivative of q at p along `speed`.
Coefficient rate_at(const Polynomial& q, const std::vector<Coefficient>& p,
                    const std::vector<Coefficient>& speed) {
  Coefficient sum;
  for (const Term& term : q.terms) {
    for (std::size_t j = 0; j < term.monomial.size(); ++j) {
      Monomial lower = term.monomial;
      const Power power = lower[j];
      if (--lower[j].exponent == 0) lower.erase(lower.begin() + static_cast<std::ptrdiff_t>(j));
      const Coefficient factor = Coefficient{Rational(power.exponent), 0} * speed[power.variable];
      sum = sum + factor * term.coefficient * exact_value_at(lower, p);
    }
  }
  return sum;
}

/// A polynomial in n unknowns and the parameters behind them, by monomials of the unknowns.
std::map<Monomial, TermMap, MonomialOrder> by_unknowns(const Polynomial& p, std::uint32_t n) {
  std::map<Monomial, TermMap, MonomialOrder> parts;
  for (const Term& term : p.terms) {
    Monomial unknowns;
    Monomial parameters;
    for (const Power& power : term.monomial) {
      if (power.variable < n) {
        unknowns.push_back(power);
      } else {
        parameters.push_back({power.variable - n, power.exponent});
      }
    }
    parts[unknowns][parameters] = term.coefficient;
  }
  return parts;
}

}  // namespace

void Homotopy::set_support(const System& affine) {
  support_ = homogenize(affine, degrees(affine));
  tape_ = make_tape(support_);
  chart_.unknowns = affine.variables.size();
  std::size_t next = 0;
  for (const Polynomial& p : support_.polynomials) {
    first_.push_back(next);
    next += p.terms.size();
  }
}

Homotopy::Homotopy(const System& f, const System& g) {
  require_square_pair(f, g);
  System support{f.variables, {}};
  for (std::size_t i = 0; i < f.polynomials.size(); ++i) {
    support.polynomials.push_back(united(f.polynomials[i], g.polynomials[i]));
    append_coefficients(support.polynomials[i], f.polynomials[i], f_);
    append_coefficients(support.polynomials[i], g.polynomials[i], g_);
  }
  set_support(support);
}

const NumberErrors& Homotopy::errors(std::size_t k) const {
  static const NumberErrors exact;
  return errors_.empty() ? exact : errors_[k];
}

double Homotopy::largest_error() const {
  double largest = 0;
  for (const NumberErrors& own : errors_) largest = std::max(largest, bound(own));
  return largest;
}

void Homotopy::set_coefficient_errors(const CoefficientErrors& errors) {
  errors_.clear();
  if (errors.empty()) return;
  std::vector<NumberErrors> of_f;
  for (const std::vector<NumberErrors>& own : errors)
    of_f.insert(of_f.end(), own.begin(), own.end());
  auto next = of_f.begin();
  for (const Coefficient& c : f_) {
    if (!is_zero(c) && next == of_f.end()) throw InvalidInput("fewer errors than coefficients");
    errors_.push_back(is_zero(c) ? NumberErrors{} : *next++);
  }
  if (next != of_f.end()) throw InvalidInput("more errors than coefficients");
}

Homotopy Homotopy::framed(const System& f, const System& g) {
  Homotopy homotopy(f, g);
  homotopy.is_framed_ = true;
  for (std::size_t k = 0; k < homotopy.terms(); ++k) {
    const Coefficient& c = is_zero(homotopy.g(k)) ? homotopy.f(k) : homotopy.g(k);
    homotopy.log2_sizes_.push_back(moivre::log2_size(c));
  }
  return homotopy;
}

Homotopy Homotopy::toric(const System& g) {
  Homotopy homotopy = framed(g, g);
  homotopy.law_ = CoefficientLaw::toric;
  return homotopy;
}

Homotopy Homotopy::members(const System& family, const Point& from) {
  const std::size_t n = family.polynomials.size();
  if (family.variables.size() != n + from.size()) {
    throw InvalidInput("a parameter homotopy needs n polynomials in n unknowns and the " +
                       counted(from.size(), "parameter") + "; got " + std::to_string(n) + " in " +
                       std::to_string(family.variables.size()) + " variables");
  }
  const auto unknowns = family.variables.begin() + static_cast<std::ptrdiff_t>(n);
  System support{{family.variables.begin(), unknowns}, {}};
  ParameterLaw law{{{unknowns, family.variables.end()}, {}}, {}, from, {}};
  for (const Polynomial& p : family.polynomials) {
    TermMap terms;
    for (auto& [monomial, coefficient] : by_unknowns(p, static_cast<std::uint32_t>(n))) {
      terms[monomial] = Coefficient{1, 0};
      law.coefficients.polynomials.push_back(to_polynomial(coefficient));
    }
    support.polynomials.push_back(to_polynomial(terms));
  }
  law.tape = make_tape(law.coefficients);
  Homotopy homotopy;
  homotopy.law_ = CoefficientLaw::parameters;
  homotopy.f_.resize(law.coefficients.polynomials.size());
  homotopy.g_ = homotopy.f_;
  homotopy.parameters_ = std::move(law);
  homotopy.set_support(support);
  return homotopy;
}

Homotopy Homotopy::parameters(const System& family, const Point& from, const Point& to) {
  if (from.size() != to.size()) {
    throw InvalidInput("a parameter homotopy needs two members; got " +
                       std::to_string(from.size()) + " and " + counted(to.size(), "parameter"));
  }
  Homotopy homotopy = members(family, from);
  ParameterLaw& law = *homotopy.parameters_;
  law.to = to;
  std::vector<Coefficient> end;
  std::vector<Coefficient> speed;
  for (std::size_t j = 0; j < to.size(); ++j) {
    end.push_back(exactly(to[j]));
    speed.push_back(end[j] - exactly(from[j]));
  }
  for (std::size_t k = 0; k < homotopy.f_.size(); ++k) {
    const Polynomial& q = law.coefficients.polynomials[k];
    homotopy.f_[k] = exact_value_at(q, end);
    homotopy.g_[k] = homotopy.f_[k] - rate_at(q, end, speed);
  }
  return homotopy;
}

}  // namespace moivre
