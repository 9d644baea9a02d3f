// SPDX-License-Identifier: MIT
// What does a polynomial look like from a point x? Its terms in y = z - x, by ascending degree.
//
// S: Residue, double or ComplexDoubleDouble. Private to the module.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "modular.h"
#include "moivre/numeric/double_double.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// Of a monomial in y.
using Exponents = std::vector<std::uint32_t>;

inline std::uint64_t degree(const Exponents& a) {
  std::uint64_t sum = 0;
  for (const std::uint32_t e : a) sum += e;
  return sum;
}

struct LocalOrder {
  bool operator()(const Exponents& a, const Exponents& b) const {
    const std::uint64_t da = degree(a);
    const std::uint64_t db = degree(b);
    return da != db ? da < db : a < b;
  }
};

template <class S>
using LocalPolynomial = std::map<Exponents, S, LocalOrder>;

/// All monomials in n unknowns of degree k at most, by ascending degree; empty where there are more than `most`.
std::vector<Exponents> monomials(std::size_t n, std::uint64_t k, std::size_t most);

inline double times(double a, double b) { return a * b; }
inline double plus(double a, double b) { return a + b; }
inline ComplexDoubleDouble times(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return product(a, b);
}
inline ComplexDoubleDouble plus(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return a + b;
}

template <class S>
void add(LocalPolynomial<S>& p, const Exponents& m, const S& c) {
  const auto [place, is_new] = p.try_emplace(m, c);
  if (!is_new) place->second = plus(place->second, c);
}

/// p(x + y), up to degree k in y. `round`: a Coefficient to S.
template <class S, class Round>
LocalPolynomial<S> moved(const Polynomial& p, const std::vector<S>& x, std::uint64_t k,
                         const Round& round) {
  LocalPolynomial<S> sum;
  for (const Term& term : p.terms) {
    LocalPolynomial<S> power{{Exponents(x.size()), round(term.coefficient)}};
    for (const Power& factor : term.monomial) {
      for (std::uint32_t e = 0; e < factor.exponent; ++e) {
        LocalPolynomial<S> next;
        for (const auto& [m, c] : power) {
          if (!(x[factor.variable] == S{})) add(next, m, times(c, x[factor.variable]));
          if (degree(m) == k) continue;
          Exponents larger = m;
          ++larger[factor.variable];
          add(next, larger, c);
        }
        power = std::move(next);
      }
    }
    for (const auto& [m, c] : power) add(sum, m, c);
  }
  std::erase_if(sum, [](const auto& term) { return term.second == S{}; });
  return sum;
}

}  // namespace moivre
