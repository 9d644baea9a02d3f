// SPDX-License-Identifier: MIT
// Members of a family: parameters replaced by their values.
#include "moivre/family/family.h"

#include <algorithm>

#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

Coefficient power(const Coefficient& base, std::uint32_t exponent) {
  Coefficient result = base;
  for (std::uint32_t e = 1; e < exponent; ++e) result = result * base;
  return result;
}

Polynomial substituted(const Polynomial& p, std::size_t unknowns, const ParameterValues& values) {
  TermMap terms;
  for (const Term& term : p.terms) {
    Monomial monomial;
    Coefficient coefficient = term.coefficient;
    for (const Power& factor : term.monomial) {
      if (factor.variable < unknowns) {
        monomial.push_back(factor);
      } else {
        coefficient = coefficient * power(values[factor.variable - unknowns], factor.exponent);
      }
    }
    Coefficient& sum = terms[monomial];
    sum = sum + coefficient;
  }
  return to_polynomial(std::move(terms));
}

}  // namespace

bool operator==(const Learning& a, const Learning& b) {
  const auto same_bound = [&] {
    if (a.bound.has_value() != b.bound.has_value()) return false;
    return !a.bound || (a.bound->kind == b.bound->kind && a.bound->value == b.bound->value);
  };
  return a.start == b.start && a.paths == b.paths && a.certified == b.certified &&
         a.dropped == b.dropped && a.complete == b.complete && a.standing == b.standing &&
         same_bound();
}

bool operator==(const Family& a, const Family& b) {
  return a.system == b.system && a.sizes == b.sizes && a.seed == b.seed && a.nonzero == b.nonzero &&
         a.generic == b.generic && a.roots == b.roots && a.learning == b.learning;
}

std::vector<std::string> Family::unknown_names() const {
  const auto end = system.variables.begin() + static_cast<std::ptrdiff_t>(unknowns());
  return {system.variables.begin(), end};
}

std::vector<std::string> Family::parameter_names() const {
  const auto begin = system.variables.begin() + static_cast<std::ptrdiff_t>(unknowns());
  return {begin, system.variables.end()};
}

System member_system(const Family& family, const ParameterValues& p) {
  if (p.size() != family.parameters()) {
    throw InvalidInput("a member of this family has " + counted(family.parameters(), "parameter") +
                       ", got " + std::to_string(p.size()));
  }
  System member;
  member.variables = family.unknown_names();
  for (const Polynomial& polynomial : family.system.polynomials) {
    member.polynomials.push_back(substituted(polynomial, family.unknowns(), p));
  }
  member.scaled_log2 = family.system.scaled_log2;
  return member;
}

Coefficient exact_value(const Complex& x) { return {Rational(x.real()), Rational(x.imag())}; }

ParameterValues exact_values(const Point& p) {
  ParameterValues values;
  for (const Complex& pj : p) values.push_back(exact_value(pj));
  return values;
}

bool is_linear_in_parameters(const Family& family) {
  const auto is_parameter = [&](const Power& power) { return power.variable >= family.unknowns(); };
  for (const Polynomial& p : family.system.polynomials) {
    for (const Term& term : p.terms) {
      std::uint64_t degree = 0;
      for (const Power& power : term.monomial) degree += is_parameter(power) ? power.exponent : 0;
      if (degree > 1) return false;
    }
  }
  return true;
}

}  // namespace moivre
