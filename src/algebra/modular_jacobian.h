// SPDX-License-Identifier: MIT
// What is det(df_i / dx_j) modulo the prime and the ideal of a Groebner basis, but for its sign?
//
//   f: n polynomials in the unknowns 0 .. n - 1
// By the columns of the first 1, 2, ... rows, each set of them once: 2^n n products. Private to the
// module.
#pragma once

#include "modular_polynomial.h"

namespace moivre {

/// nullopt beyond the largest degree, and where the budget is used up.
std::optional<ModularPolynomial> jacobian_determinant(
    const PrimeField& field, const std::vector<ModularPolynomial>& f,
    const std::vector<const ModularPolynomial*>& basis, TermBudget& budget);

}  // namespace moivre
