// SPDX-License-Identifier: MIT
// What do formulations need of polynomials beside polynomial/system.h? Differences of rounded
// numbers, and sizes.
#pragma once

#include <algorithm>

#include "moivre/polynomial/system.h"

namespace moivre {

inline double largest_coefficient(const Polynomial& p) {
  double largest = 0;
  for (const Term& term : p.terms) {
    largest = std::max(largest, std::abs(to_complex(term.coefficient)));
  }
  return largest;
}

/// a - b where both have coefficients of lengths and points as typed, right to half a unit of their
/// last digit: terms that cancel but for that do cancel. Left in, they would be roots at 1e16
/// instead of none.
inline Polynomial rounded_difference(const Polynomial& a, const Polynomial& b) {
  constexpr double kRounding = 1e-14;  // a sum of a few squares of numbers right to 2^-53
  const auto size = [](const Polynomial& p, const Monomial& of) {
    const auto at = std::lower_bound(
        p.terms.begin(), p.terms.end(), of,
        [](const Term& term, const Monomial& m) { return precedes(term.monomial, m); });
    const bool is_there = at != p.terms.end() && at->monomial == of;
    return is_there ? std::abs(to_complex(at->coefficient)) : 0;
  };
  Polynomial difference = a - b;
  auto& terms = difference.terms;
  terms.erase(std::remove_if(terms.begin(), terms.end(),
                             [&](const Term& term) {
                               return std::abs(to_complex(term.coefficient)) <=
                                      kRounding * (size(a, term.monomial) + size(b, term.monomial));
                             }),
              terms.end());
  return difference;
}

}  // namespace moivre
