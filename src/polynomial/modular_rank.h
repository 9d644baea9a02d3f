// SPDX-License-Identifier: MIT
// Are these rows surely independent? Rank modulo a prime, a lower bound for the exact rank. Private
// to the module.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "moivre/polynomial/integer_polynomial.h"

namespace moivre {

/// Rank modulo the prime of the parts of the given degree, rows in the order given; of those before
/// `stop` was set, where it is meanwhile.
std::size_t modular_rank(const std::vector<const IntegerPolynomial*>& rows, std::uint64_t degree,
                         const std::atomic<bool>* stop = nullptr);

}  // namespace moivre
