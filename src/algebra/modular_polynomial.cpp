// SPDX-License-Identifier: MIT
// Monomials as bytes, polynomials as sorted terms that are merged.
#include "modular_polynomial.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace moivre {
namespace {

bool is_larger(const DegreeAndExponents& a, const DegreeAndExponents& b) {
  return is_smaller(b, a);
}

DegreeAndExponents product(const DegreeAndExponents& a, const DegreeAndExponents& b) {
  DegreeAndExponents ab;
  for (std::size_t i = 0; i < ab.at.size(); ++i) {
    ab.at[i] = static_cast<std::uint8_t>(a.at[i] + b.at[i]);
  }
  return ab;
}

/// Into `sum`: terms of p from `first` on, plus those of c m q from `second` on.
void merge(const PrimeField& field, const ModularPolynomial& p, std::size_t first, Residue c,
           const DegreeAndExponents& m, const ModularPolynomial& q, std::size_t second,
           ModularPolynomial& sum) {
  sum.clear();
  auto a = p.begin() + static_cast<std::ptrdiff_t>(first);
  for (auto b = q.begin() + static_cast<std::ptrdiff_t>(second); b != q.end(); ++b) {
    const DegreeAndExponents moved = product(m, b->first);
    while (a != p.end() && is_larger(a->first, moved)) sum.push_back(*a++);
    Residue value = field.times(c, b->second);
    if (a != p.end() && a->first == moved) value = field.plus(value, (a++)->second);
    if (value != 0) sum.emplace_back(moved, value);
  }
  sum.insert(sum.end(), a, p.end());
}

}  // namespace

ModularPolynomial monic(const PrimeField& field, ModularPolynomial p) {
  if (p.empty() || p.front().second == 1) return p;
  const Residue scale = field.inverse(p.front().second);
  for (auto& [m, c] : p) c = field.times(c, scale);
  return p;
}

bool is_smaller(const DegreeAndExponents& a, const DegreeAndExponents& b) {
  if (a.at[0] != b.at[0]) return a.at[0] < b.at[0];
  return std::memcmp(a.at.data(), b.at.data(), a.at.size()) > 0;
}

bool divides(const DegreeAndExponents& a, const DegreeAndExponents& b) {
  bool all = true;
  for (std::size_t i = 0; i < a.at.size(); ++i) all &= a.at[i] <= b.at[i];
  return all;
}

DegreeAndExponents quotient(const DegreeAndExponents& multiple, const DegreeAndExponents& divisor) {
  DegreeAndExponents q;
  for (std::size_t i = 0; i < q.at.size(); ++i) {
    q.at[i] = static_cast<std::uint8_t>(multiple.at[i] - divisor.at[i]);
  }
  return q;
}

std::optional<DegreeAndExponents> lcm(const DegreeAndExponents& a, const DegreeAndExponents& b) {
  DegreeAndExponents m;
  std::uint64_t degree = 0;
  for (std::size_t i = 1; i < m.at.size(); ++i) {
    m.at[i] = std::max(a.at[i], b.at[i]);
    degree += m.at[i];
  }
  if (degree > DegreeAndExponents::kMostDegree) return std::nullopt;
  m.at[0] = static_cast<std::uint8_t>(degree);
  return m;
}

bool are_coprime(const DegreeAndExponents& a, const DegreeAndExponents& b) {
  for (std::size_t i = 1; i < a.at.size(); ++i) {
    if (a.at[i] != 0 && b.at[i] != 0) return false;
  }
  return true;
}

std::optional<ModularPolynomial> modular(const PrimeField& field, const Polynomial& p) {
  ModularPolynomial image;
  for (const Term& term : p.terms) {
    DegreeAndExponents m;
    std::uint64_t degree = 0;
    for (const Power& power : term.monomial) {
      degree += power.exponent;
      if (degree > DegreeAndExponents::kMostDegree) return std::nullopt;
      m.at[1 + power.variable] = static_cast<std::uint8_t>(power.exponent);
    }
    m.at[0] = static_cast<std::uint8_t>(degree);
    image.emplace_back(m, field.residue(term.coefficient));
  }
  std::sort(image.begin(), image.end(),
            [](const auto& a, const auto& b) { return is_larger(a.first, b.first); });
  return monic(field, std::move(image));
}

std::optional<ModularPolynomial> reduced(const PrimeField& field, ModularPolynomial p,
                                         const std::vector<const ModularPolynomial*>& basis,
                                         TermBudget& budget) {
  ModularPolynomial rest;
  ModularPolynomial sum;
  std::size_t first = 0;
  while (first < p.size()) {
    const DegreeAndExponents m = p[first].first;
    const auto divisor = std::find_if(basis.begin(), basis.end(),
                                      [&](const auto* q) { return divides(q->front().first, m); });
    budget.spend(1);
    if (divisor == basis.end()) {
      rest.push_back(p[first++]);
      continue;
    }
    const ModularPolynomial& q = **divisor;
    // The first terms cancel.
    merge(field, p, first + 1, field.minus(p[first].second), quotient(m, q.front().first), q, 1,
          sum);
    std::swap(p, sum);
    first = 0;
    budget.spend(p.size());
    if (budget.is_used_up()) return std::nullopt;
  }
  return rest;
}

std::optional<ModularPolynomial> sum(const PrimeField& field, const ModularPolynomial& p, Residue c,
                                     const DegreeAndExponents& m, const ModularPolynomial& q,
                                     TermBudget& budget) {
  if (q.empty()) return p;
  if (m.degree() + q.front().first.degree() > DegreeAndExponents::kMostDegree) return std::nullopt;
  ModularPolynomial result;
  merge(field, p, 0, c, m, q, 0, result);
  budget.spend(result.size());
  if (budget.is_used_up()) return std::nullopt;
  return result;
}

std::optional<ModularPolynomial> s_polynomial(const PrimeField& field, const ModularPolynomial& p,
                                              const ModularPolynomial& q) {
  const auto common = lcm(p.front().first, q.front().first);
  if (!common) return std::nullopt;
  const DegreeAndExponents factor = quotient(*common, p.front().first);
  ModularPolynomial multiple = p;
  for (auto& [m, c] : multiple) m = product(factor, m);
  ModularPolynomial difference;
  merge(field, multiple, 1, field.minus(1), quotient(*common, q.front().first), q, 1, difference);
  return difference;
}

}  // namespace moivre
