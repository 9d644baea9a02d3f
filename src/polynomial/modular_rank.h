// SPDX-License-Identifier: MIT
// Are these rows surely independent? Rank modulo a prime, a lower bound for the exact rank. Private to the module.
//
// The prime 2^61 - 31 is 1 modulo 4, so that -1 has a square root and Gaussian integers have images. Rows that are
// independent modulo the prime are independent; the converse fails with probability about 1e-18.
#pragma once

#include <cstdint>
#include <vector>

#include "integer_polynomial.h"

namespace moivre {

/// Rank modulo the prime of the parts of the given degree, rows in the order given.
std::size_t modular_rank(const std::vector<const IntegerPolynomial*>& rows, std::uint64_t degree);

}  // namespace moivre
