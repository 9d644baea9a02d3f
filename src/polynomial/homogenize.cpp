// SPDX-License-Identifier: MIT
// Multiplies every term up to the degree of its equation with powers of the homogenizing
// coordinate.
#include "moivre/polynomial/homogenize.h"

#include <limits>

#include "moivre/numeric/invalid_input.h"

namespace moivre {

System homogenize(const System& f, const std::vector<std::uint64_t>& degrees) {
  const auto n = static_cast<std::uint32_t>(f.variables.size());
  System result;
  result.variables = f.variables;
  result.variables.push_back("homogenizing coordinate");
  for (std::size_t i = 0; i < f.polynomials.size(); ++i) {
    Polynomial& homogeneous = result.polynomials.emplace_back();
    for (const Term& term : f.polynomials[i].terms) {
      const std::uint64_t own = degree(term.monomial);
      if (own > degrees[i] || degrees[i] > std::numeric_limits<std::uint32_t>::max()) {
        throw InvalidInput("equation " + std::to_string(i + 1) +
                           " cannot be homogenized to degree " + std::to_string(degrees[i]));
      }
      Monomial m = term.monomial;
      if (own < degrees[i]) m.push_back({n, static_cast<std::uint32_t>(degrees[i] - own)});
      homogeneous.terms.push_back({term.coefficient, std::move(m)});
    }
  }
  return result;
}

}  // namespace moivre
