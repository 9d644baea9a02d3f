// SPDX-License-Identifier: MIT
// What becomes of an element of the quotient ring that is multiplied by a linear form? One matrix
// modulo the prime.
//
//   basis   the monomials under the staircase, ascending; D of them
//   M       column j: the normal form of (c_1 x_1 + ... + c_n x_n) basis_j
//
// Its minimal polynomial has the values of the form at the roots as roots [Wiedemann86]. Private to
// the module.
#pragma once

#include "groebner_basis.h"
#include "moivre/polynomial/modular_line.h"

namespace moivre {

/// Square, by rows that are mostly full.
class Multiplication {
 public:
  Multiplication(const PrimeField& field, std::size_t dimension)
      : field_(field), dimension_(dimension), rows_(dimension * dimension) {}

  std::size_t dimension() const { return dimension_; }
  Residue& at(std::size_t i, std::size_t j) { return rows_[i * dimension_ + j]; }
  Residue at(std::size_t i, std::size_t j) const { return rows_[i * dimension_ + j]; }

  /// M x.
  std::vector<Residue> times_vector(const std::vector<Residue>& x) const;
  /// l M.
  std::vector<Residue> vector_times(const std::vector<Residue>& l) const;

 private:
  PrimeField field_;
  std::size_t dimension_;
  std::vector<Residue> rows_;
};

Residue product(const PrimeField& field, const Residue* a, const std::vector<Residue>& b);

/// As a vector by the basis.
std::vector<Residue> by_basis(const std::vector<LeadingMonomial>& basis,
                              const ModularPolynomial& normal_form);

/// nullopt where a degree is too large or the budget is used up.
std::optional<Multiplication> multiplication_by(GroebnerBasis& ideal,
                                                const std::vector<LeadingMonomial>& basis,
                                                const std::vector<Residue>& form);

}  // namespace moivre
