// SPDX-License-Identifier: MIT
// Exact elimination of linear equations, as polynomials put into polynomials.
#include "linear_values.h"

#include <algorithm>

#include "arithmetic.h"

namespace moivre {
namespace {

// Relative to the polynomial's largest coefficient: products of a few decimals of 16 digits are
// right to this.
constexpr double kOfLargest = 1e-12;

}  // namespace

LinearValues::LinearValues(const Formulation& formulation)
    : formulation_(formulation), solved_(formulation.system.variables.size()) {
  for (const Polynomial& equation : formulation.system.polynomials) {
    if (degree(equation) == 1) add(equation);
  }
}

Polynomial LinearValues::substituted(const Polynomial& p) const {
  Polynomial sum;
  for (const Term& term : p.terms) {
    Polynomial product = constant(term.coefficient);
    for (const Power& factor : term.monomial) {
      const auto& known = solved_[factor.variable];
      const Polynomial x = known ? *known : unknown(factor.variable);
      for (std::uint32_t k = 0; k < factor.exponent; ++k) product = product * x;
    }
    sum = sum + product;
  }
  return sum;
}

/// Solves it for a length. Directions stay: t u = 1 would be lost on their sums.
void LinearValues::add(const Polynomial& equation) {
  const Polynomial rest = substituted(equation);
  const auto pivot = std::find_if(rest.terms.begin(), rest.terms.end(), [&](const Term& term) {
    return !term.monomial.empty() && !formulation_.is_direction[term.monomial.front().variable];
  });
  if (pivot == rest.terms.end()) return;
  const std::uint32_t variable = pivot->monomial.front().variable;
  const Coefficient scale = Coefficient{-1, 0} / pivot->coefficient;
  solved_[variable] = scale * rest + unknown(variable);
  for (auto& known : solved_) {
    if (known) known = substituted(*known);
  }
}

/// Without t u, which is 1.
Monomial LinearValues::without_pairs(Monomial m) const {
  for (Power& factor : m) {
    if (!formulation_.is_direction[factor.variable]) continue;
    const auto mirror = static_cast<std::uint32_t>(formulation_.mirror[factor.variable]);
    const auto other = std::find_if(m.begin(), m.end(),
                                    [&](const Power& power) { return power.variable == mirror; });
    if (other == m.end() || &*other == &factor) continue;
    const std::uint32_t common = std::min(factor.exponent, other->exponent);
    factor.exponent -= common;
    other->exponent -= common;
  }
  std::erase_if(m, [](const Power& factor) { return factor.exponent == 0; });
  return m;
}

std::optional<Complex> LinearValues::value(const Polynomial& p) const {
  TermMap sums;
  for (const Term& term : substituted(p).terms) {
    Coefficient& sum = sums[without_pairs(term.monomial)];
    sum = sum + term.coefficient;
  }
  const double rounding = kOfLargest * largest_coefficient(p);
  Complex value = 0;
  for (const auto& [monomial, coefficient] : sums) {
    if (monomial.empty()) {
      value = to_complex(coefficient);
    } else if (std::abs(to_complex(coefficient)) > rounding) {
      return std::nullopt;
    }
  }
  return value;
}

}  // namespace moivre
