// SPDX-License-Identifier: MIT
// Equal squares paired, and monomials multiplied out in the new unknowns.
#include "moivre/polynomial/isotropic.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace moivre {
namespace {

/// The unknown whose square this monomial is.
std::optional<std::size_t> squared_unknown(const Monomial& m) {
  if (m.size() != 1 || m.front().exponent != 2) return std::nullopt;
  return m.front().variable;
}

/// Unknowns with squares of one coefficient, where they are two.
std::vector<IsotropicPair> pairs_in(const Polynomial& p) {
  std::vector<std::pair<const Coefficient*, std::vector<std::size_t>>> squares;
  for (const Term& term : p.terms) {
    const auto x = squared_unknown(term.monomial);
    if (!x) continue;
    const auto same = std::find_if(squares.begin(), squares.end(), [&](const auto& other) {
      return *other.first == term.coefficient;
    });
    if (same == squares.end()) {
      squares.push_back({&term.coefficient, {*x}});
    } else {
      same->second.push_back(*x);
    }
  }
  std::vector<IsotropicPair> pairs;
  for (const auto& [c, unknowns] : squares) {
    if (unknowns.size() != 2) continue;
    const auto [i, j] = std::minmax(unknowns[0], unknowns[1]);
    pairs.emplace_back(i, j);
  }
  return pairs;
}

/// Monomials of old unknowns in the new ones.
class Change {
 public:
  Change(std::size_t n, const std::vector<IsotropicPair>& pairs) {
    std::vector<Polynomial> x = unknowns(n);
    leave_isotropic(pairs, x, [](const Coefficient& c) { return constant(c); });
    images_ = std::move(x);
  }

  Polynomial of(const Monomial& m) {
    Polynomial result = constant(1);
    for (const Power& power : m) result *= power_of(power);
    return result;
  }

  Polynomial of(const Polynomial& p) {
    TermMap sum;
    for (const Term& term : p.terms) {
      for (const Term& part : of(term.monomial).terms) {
        Coefficient& c = sum[part.monomial];
        c = c + term.coefficient * part.coefficient;
      }
    }
    return to_polynomial(std::move(sum));
  }

 private:
  const Polynomial& power_of(const Power& power) {
    auto [place, is_new] = powers_.try_emplace({power.variable, power.exponent});
    if (is_new) place->second = pow(images_[power.variable], static_cast<int>(power.exponent));
    return place->second;
  }

  std::vector<Polynomial> images_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Polynomial> powers_;
};

}  // namespace

std::vector<IsotropicPair> isotropic_pairs(const System& f) {
  std::vector<IsotropicPair> pairs;
  for (const Polynomial& p : f.polynomials) {
    for (const IsotropicPair& pair : pairs_in(p)) {
      if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
    }
  }
  std::map<std::size_t, int> uses;
  for (const auto& [i, j] : pairs) {
    ++uses[i];
    ++uses[j];
  }
  std::erase_if(pairs, [&](const IsotropicPair& pair) {
    return uses[pair.first] > 1 || uses[pair.second] > 1;
  });
  return pairs;
}

System in_isotropic(const System& f, const std::vector<IsotropicPair>& pairs) {
  System result;
  result.variables = f.variables;
  result.is_exact = f.is_exact;
  for (const auto& [i, j] : pairs) {
    result.variables[i] = f.variables[i] + " + i " + f.variables[j];
    result.variables[j] = f.variables[i] + " - i " + f.variables[j];
  }
  Change change(f.variables.size(), pairs);
  for (const Polynomial& p : f.polynomials) result.polynomials.push_back(change.of(p));
  return result;
}

CoefficientErrors errors_in_isotropic(const System& f, const CoefficientErrors& errors,
                                      const std::vector<IsotropicPair>& pairs) {
  if (errors.empty()) return {};
  Change change(f.variables.size(), pairs);
  CoefficientErrors result;
  for (std::size_t k = 0; k < f.polynomials.size(); ++k) {
    std::map<Monomial, NumberErrors, MonomialOrder> absolute;
    const Polynomial& p = f.polynomials[k];
    for (std::size_t t = 0; t < p.terms.size(); ++t) {
      if (errors[k][t].empty()) continue;
      const Complex c = to_complex(p.terms[t].coefficient);
      for (const Term& part : change.of(p.terms[t].monomial).terms) {
        add(absolute[part.monomial], c * to_complex(part.coefficient), errors[k][t]);
      }
    }
    std::vector<NumberErrors>& own = result.emplace_back();
    for (const Term& term : change.of(p).terms) {
      NumberErrors& relative = own.emplace_back();
      const auto found = absolute.find(term.monomial);
      if (found == absolute.end()) continue;
      add(relative, 1.0 / to_complex(term.coefficient), found->second);
      if (!std::isfinite(bound(relative))) relative.clear();
    }
  }
  return result;
}

void enter_isotropic(const std::vector<IsotropicPair>& pairs, std::vector<Complex>& x) {
  const Complex imaginary(0, 1);
  for (const auto& [i, j] : pairs) {
    const Complex a = x[i], b = x[j];
    x[i] = a + imaginary * b;
    x[j] = a - imaginary * b;
  }
}

}  // namespace moivre
