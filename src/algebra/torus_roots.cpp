// SPDX-License-Identifier: MIT
// Rows degree by degree, then each unit vector beside them.
#include "moivre/algebra/torus_roots.h"

#include <algorithm>
#include <map>

#include "local_polynomial.h"
#include "moivre/polynomial/modular.h"

namespace moivre {
namespace {

// Columns of the largest matrix: its rows are reduced in a tenth of a second.
constexpr std::size_t kMostMonomials = 400;

using Equation = LocalPolynomial<Residue>;

/// Divided by the monomial that all terms share, which is not 0 here.
Equation without_common_factor(const PrimeField& field, const Polynomial& p, std::size_t n) {
  std::vector<std::pair<Exponents, Residue>> terms;
  Exponents common(n, UINT32_MAX);
  for (const Term& term : p.terms) {
    Exponents a(n);
    for (const Power& factor : term.monomial) a[factor.variable] = factor.exponent;
    for (std::size_t j = 0; j < n; ++j) common[j] = std::min(common[j], a[j]);
    terms.emplace_back(std::move(a), field.residue(term.coefficient));
  }
  Equation equation;
  for (auto& [a, c] : terms) {
    for (std::size_t j = 0; j < n; ++j) a[j] -= common[j];
    equation.emplace(std::move(a), c);
  }
  return equation;
}

std::uint64_t degree_of(const Equation& equation) { return degree(equation.rbegin()->first); }

class Span {
 public:
  explicit Span(const System& f) : field_(f), n_(f.variables.size()), rows_(field_) {
    for (const Polynomial& p : f.polynomials) {
      equations_.push_back(without_common_factor(field_, p, n_));
      least_degree_ = std::max(least_degree_, degree_of(equations_.back()));
    }
  }

  std::uint64_t least_degree() const { return least_degree_; }

  /// Adds the rows of degree k, after those of all smaller ones. False: too many monomials.
  bool extend_to(std::uint64_t k) {
    monomials_ = monomials(n_, k, kMostMonomials);
    for (std::size_t c = 0; c < monomials_.size(); ++c) column_.emplace(monomials_[c], c);
    for (const Equation& equation : equations_) {
      for (const Exponents& factor : monomials_) {
        if (degree(factor) + degree_of(equation) == k) rows_.add(multiple(factor, equation));
      }
    }
    return !monomials_.empty();
  }

  bool holds_a_monomial() const {
    for (std::size_t c = 0; c < monomials_.size(); ++c) {
      if (rows_.span({{c, 1}})) return true;
    }
    return false;
  }

 private:
  ModularRow multiple(const Exponents& factor, const Equation& equation) const {
    ModularRow row;
    for (const auto& [a, c] : equation) {
      Exponents product = a;
      for (std::size_t j = 0; j < n_; ++j) product[j] += factor[j];
      row.emplace_back(column_.at(product), c);
    }
    std::sort(row.begin(), row.end());
    return row;
  }

  PrimeField field_;
  std::size_t n_;
  std::vector<Equation> equations_;
  std::uint64_t least_degree_ = 0;
  std::vector<Exponents> monomials_;
  std::map<Exponents, std::size_t, LocalOrder> column_;
  ModularRows rows_;
};

}  // namespace

bool has_no_torus_root(const System& f) {
  const bool has_one_term = std::any_of(f.polynomials.begin(), f.polynomials.end(),
                                        [](const Polynomial& p) { return p.terms.size() == 1; });
  if (has_one_term) return true;
  if (f.polynomials.size() <= f.variables.size()) return false;
  Span span(f);
  std::uint64_t k = 0;
  while (k < span.least_degree()) {
    if (!span.extend_to(k++)) return false;
  }
  for (; span.extend_to(k); ++k) {
    if (span.holds_a_monomial()) return true;
  }
  return false;
}

}  // namespace moivre
