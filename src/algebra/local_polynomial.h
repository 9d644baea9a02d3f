// SPDX-License-Identifier: MIT
// What does a polynomial look like from a point x? Its terms in y = z - x, by ascending degree.
//
// S: a residue, double or ComplexDoubleDouble. Private to the module.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

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

/// All monomials in n unknowns of degree k at most, by ascending degree; empty where there are more
/// than `most`.
std::vector<Exponents> monomials(std::size_t n, std::uint64_t k, std::size_t most);

/// Sums and products of rounded numbers, as a PrimeField has those of residues.
struct RoundedNumbers {
  static double times(double a, double b) { return a * b; }
  static double plus(double a, double b) { return a + b; }
  static ComplexDoubleDouble times(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
    return product(a, b);
  }
  static ComplexDoubleDouble plus(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
    return a + b;
  }
};

template <class Field, class S>
void add(const Field& field, LocalPolynomial<S>& p, const Exponents& m, const S& c) {
  const auto [place, is_new] = p.try_emplace(m, c);
  if (!is_new) place->second = field.plus(place->second, c);
}

/// p(x + y), up to degree k in y. `round`: a Coefficient to S.
template <class Field, class S, class Round>
LocalPolynomial<S> moved(const Field& field, const Polynomial& p, const std::vector<S>& x,
                         std::uint64_t k, const Round& round) {
  LocalPolynomial<S> sum;
  for (const Term& term : p.terms) {
    LocalPolynomial<S> power{{Exponents(x.size()), round(term.coefficient)}};
    for (const Power& factor : term.monomial) {
      for (std::uint32_t e = 0; e < factor.exponent; ++e) {
        LocalPolynomial<S> next;
        for (const auto& [m, c] : power) {
          if (!(x[factor.variable] == S{})) add(field, next, m, field.times(c, x[factor.variable]));
          if (degree(m) == k) continue;
          Exponents larger = m;
          ++larger[factor.variable];
          add(field, next, larger, c);
        }
        power = std::move(next);
      }
    }
    for (const auto& [m, c] : power) add(field, sum, m, c);
  }
  std::erase_if(sum, [](const auto& term) { return term.second == S{}; });
  return sum;
}

}  // namespace moivre
