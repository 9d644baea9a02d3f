// SPDX-License-Identifier: MIT
// A polynomial evaluated term by term.
#include "moivre/polynomial/value.h"

namespace moivre {
namespace {

Complex value_of(const Term& term, const Point& x) {
  Complex product = to_complex(term.coefficient);
  for (const Power& factor : term.monomial) {
    for (std::uint32_t k = 0; k < factor.exponent; ++k) product *= x[factor.variable];
  }
  return product;
}

}  // namespace

Complex value_at(const Polynomial& p, const Point& x) {
  Complex sum = 0;
  for (const Term& term : p.terms) sum += value_of(term, x);
  return sum;
}

double term_size(const Polynomial& p, const Point& x) {
  double sum = 0;
  for (const Term& term : p.terms) sum += std::abs(value_of(term, x));
  return sum;
}

}  // namespace moivre
