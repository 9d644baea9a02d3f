// SPDX-License-Identifier: MIT
// Which polynomials of an ideal have all leading monomials? A Groebner basis modulo a prime, degree
// reverse lexicographic order, and the monomials under its staircase, which are a basis of the
// quotient ring.
//
// The pair of the least common multiple comes first; which pairs are needed [GebauerMoeller88].
// Leading monomials that are found bound the dimension already, and a bound that is met ends the
// search. Not supported: more than 15 unknowns, degrees beyond 255; no more terms are looked at
// than allowed. Private to the module. Source: [Buchberger65].
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "modular_polynomial.h"

namespace moivre {

using LeadingMonomial = DegreeAndExponents;

class GroebnerBasis {
 public:
  /// known: the search ends where no more monomials are under the staircase. stop may be nullptr.
  GroebnerBasis(const PrimeField& field, std::size_t n, std::uint64_t most_terms,
                const std::atomic<bool>* stop, std::uint64_t known)
      : field_(field), n_(n), stop_(stop), known_(known), budget_(most_terms) {}

  /// Of these, and what was added before, each reduced in turn. False where it is given up.
  bool add(std::vector<ModularPolynomial> f);
  /// One unknown more, the last. Requires room for it. A dimension that was known does not count
  /// for what is added then.
  void add_unknown();

  std::size_t unknowns() const { return n_; }
  const PrimeField& field() const { return field_; }
  TermBudget& budget() { return budget_; }

  /// A power of each unknown leads.
  bool is_finite() const;
  /// Those that no leading one divides, ascending; finite. nullopt where the budget is used up.
  std::optional<std::vector<LeadingMonomial>> monomials();
  /// Modulo the ideal. nullopt where it is given up.
  std::optional<ModularPolynomial> normal_form(ModularPolynomial p);
  std::vector<const ModularPolynomial*> reducers() const;

 private:
  struct Pair {
    std::size_t first = 0;
    std::size_t second = 0;
    LeadingMonomial lcm;
  };

  LeadingMonomial leading(std::size_t i) const { return elements_[i].front().first; }
  bool is_completed();
  bool take(ModularPolynomial p);
  bool pair_up(std::size_t h);
  bool is_needed(const std::vector<Pair>& fresh, std::size_t k) const;
  Pair next_pair();

  PrimeField field_;
  std::size_t n_;
  const std::atomic<bool>* stop_;
  std::uint64_t known_;
  TermBudget budget_;
  std::deque<ModularPolynomial> elements_;  // all that were found
  std::vector<std::size_t> minimal_;        // those whose leading monomial no other divides
  std::vector<Pair> pairs_;
  bool is_enough_ = false;
};

/// Of f, in kMostUnknowns at most. nullopt where a degree is too large.
std::optional<std::vector<ModularPolynomial>> modular_images(const PrimeField& field,
                                                             const System& f);

}  // namespace moivre
