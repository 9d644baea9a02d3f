// SPDX-License-Identifier: MIT
// Every factor near 1 put to 1 again, in the polynomials that have all terms.
#include <algorithm>

#include "moivre/formulation/formulation.h"

namespace moivre {
namespace {

Monomial of_unknowns(const Monomial& m, std::size_t unknowns) {
  const auto factors = std::find_if(m.begin(), m.end(),
                                    [&](const Power& power) { return power.variable >= unknowns; });
  return {m.begin(), factors};
}

Polynomial without_factors(const Polynomial& p, std::size_t unknowns) {
  TermMap terms;
  for (const Term& term : p.terms) {
    Coefficient& sum = terms[of_unknowns(term.monomial, unknowns)];
    sum = sum + term.coefficient;
  }
  return to_polynomial(std::move(terms));
}

/// Whether p without its factors has lost none of its terms.
bool has_terms_of(const Polynomial& plain, const Polynomial& p, std::size_t unknowns) {
  return std::all_of(p.terms.begin(), p.terms.end(), [&](const Term& term) {
    const Monomial m = of_unknowns(term.monomial, unknowns);
    return std::any_of(plain.terms.begin(), plain.terms.end(),
                       [&](const Term& other) { return other.monomial == m; });
  });
}

}  // namespace

std::optional<Formulation> with_typed_terms(const Formulation& formulation) {
  if (!formulation.enclosed) return std::nullopt;
  const std::size_t unknowns = formulation.system.variables.size();
  EnclosedPolynomials enclosed = formulation.enclosed();
  Formulation typed = formulation;
  enclosed.has_same_terms = true;
  for (std::size_t k = 0; k < enclosed.polynomials.size(); ++k) {
    const Polynomial& p = enclosed.polynomials[k];
    typed.system.polynomials[k] = without_factors(p, unknowns);
    enclosed.has_same_terms =
        enclosed.has_same_terms && has_terms_of(typed.system.polynomials[k], p, unknowns);
  }
  if (typed.system.polynomials == formulation.system.polynomials) return std::nullopt;
  typed.enclosed = [enclosed] { return enclosed; };
  return typed;
}

}  // namespace moivre
