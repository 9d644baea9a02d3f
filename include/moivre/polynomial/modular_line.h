// SPDX-License-Identifier: MIT
// What can be told of a polynomial in one unknown modulo the prime: its gcd with others, its
// different roots, and which one a sequence obeys?
//
// Degrees are less than the prime. Private to the module. Sources: [Massey69], [Wiedemann86].
#pragma once

#include <cstddef>
#include <vector>

#include "moivre/polynomial/prime_field.h"

namespace moivre {

/// From the constant on; the last coefficient is not 0.
using Line = std::vector<Residue>;

void trim(Line& p);
Line derivative(const PrimeField& field, const Line& p);
/// Of polynomials that are not both 0.
std::size_t degree_of_gcd(const PrimeField& field, Line a, Line b);
/// In whatever field; of p other than 0.
std::size_t distinct_roots(const PrimeField& field, const Line& p);

/// The shortest recurrence p_0 s_k + ... + p_L s_{k+L} = 0 of the sequence, p_L = 1; for the one
/// there is, the sequence has 2 L numbers.
Line minimal_polynomial(const PrimeField& field, const std::vector<Residue>& s);

}  // namespace moivre
