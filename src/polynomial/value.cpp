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

Complex value_at(const Polynomial& p, const Point& x) {
  Complex sum = 0;
  for (const Term& term : p.terms) sum += to_complex(term.coefficient) * value_at(term.monomial, x);
  return sum;
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

double term_size(const Polynomial& p, const Point& x) {
  double sum = 0;
  for (const Term& term : p.terms)
    sum += std::abs(to_complex(term.coefficient) * value_at(term.monomial, x));
  return sum;
}

}  // namespace moivre
