// SPDX-License-Identifier: MIT
// A polynomial evaluated term by term.
#include "moivre/polynomial/value.h"

namespace moivre {
Complex value_at(const Monomial& monomial, const Point& x) {
  Complex value = 1;
  for (const Power& power : monomial) {
    for (std::uint32_t k = 0; k < power.exponent; ++k) value *= x[power.variable];
  }
  return value;
}

Point rounded_coefficients(const Polynomial& p) {
  Point coefficients;
  coefficients.reserve(p.terms.size());
  for (const Term& term : p.terms) coefficients.push_back(to_complex(term.coefficient));
  return coefficients;
}

Complex value_at(const Polynomial& p, const Point& coefficients, const Point& x) {
  Complex sum = 0;
  for (std::size_t k = 0; k < p.terms.size(); ++k) {
    sum += coefficients[k] * value_at(p.terms[k].monomial, x);
  }
  return sum;
}

Complex value_at(const Polynomial& p, const Point& x) {
  return value_at(p, rounded_coefficients(p), x);
}

Coefficient exact_value_at(const Monomial& monomial, const std::vector<Coefficient>& x) {
  Coefficient value{1, 0};
  for (const Power& power : monomial) {
    for (std::uint32_t k = 0; k < power.exponent; ++k) value = value * x[power.variable];
  }
  return value;
}

Coefficient exact_value_at(const Polynomial& p, const std::vector<Coefficient>& x) {
  Coefficient sum;
  for (const Term& term : p.terms) sum = sum + term.coefficient * exact_value_at(term.monomial, x);
  return sum;
}

double term_size(const Polynomial& p, const Point& coefficients, const Point& x) {
  double sum = 0;
  for (std::size_t k = 0; k < p.terms.size(); ++k) {
    sum += std::abs(coefficients[k] * value_at(p.terms[k].monomial, x));
  }
  return sum;
}

double term_size(const Polynomial& p, const Point& x) {
  return term_size(p, rounded_coefficients(p), x);
}

}  // namespace moivre
