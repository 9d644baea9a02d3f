// SPDX-License-Identifier: MIT
// Exponent vectors from polynomials, and the term 0 where it is missing.
#include "moivre/start/support.h"

#include <algorithm>
#include <string>
#include <utility>

#include "moivre/numeric/invalid_input.h"

namespace moivre {

std::vector<Support> supports_of(const System& f) {
  std::vector<Support> supports;
  for (const Polynomial& p : f.polynomials) {
    Support& support = supports.emplace_back();
    for (const Term& term : p.terms) {
      Exponents exponents(f.variables.size(), 0);
      for (const Power& power : term.monomial) exponents[power.variable] = power.exponent;
      support.terms.push_back(std::move(exponents));
    }
  }
  return supports;
}

namespace {

void check_lengths(const std::vector<Support>& supports, std::size_t n) {
  for (std::size_t i = 0; i < supports.size(); ++i) {
    for (const Exponents& term : supports[i].terms) {
      if (term.size() == n) continue;
      throw InvalidInput("a term of support " + std::to_string(i + 1) + " has " +
                         std::to_string(term.size()) + " exponents for " + std::to_string(n) +
                         " variables");
    }
  }
}

}  // namespace

void check_square(const std::vector<Support>& supports) {
  check_lengths(supports, supports.size());
}

SupportsWithOrigin with_origin(std::vector<Support> supports, std::size_t n) {
  check_lengths(supports, n);
  SupportsWithOrigin result;
  const Exponents zero(n, 0);
  for (Support& support : supports) {
    const auto found = std::find(support.terms.begin(), support.terms.end(), zero);
    result.origin.push_back(static_cast<std::size_t>(found - support.terms.begin()));
    result.added.push_back(found == support.terms.end());
    if (result.added.back()) support.terms.push_back(zero);
  }
  result.supports = std::move(supports);
  return result;
}

}  // namespace moivre
