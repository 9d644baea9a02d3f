// SPDX-License-Identifier: MIT
// What is a count that leaves 64 bits? 2^64 - 1, and it stays there: sums and products of counts
// that stop at the top.
#pragma once

#include <cstdint>
#include <limits>

namespace moivre {

inline bool is_saturated(std::uint64_t a) { return a == std::numeric_limits<std::uint64_t>::max(); }

inline std::uint64_t saturating_sum(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t sum = a + b;
  return sum < a ? std::numeric_limits<std::uint64_t>::max() : sum;
}

inline std::uint64_t saturating_product(std::uint64_t a, std::uint64_t b) {
  if (a == 0 || b == 0) return 0;
  const std::uint64_t top = std::numeric_limits<std::uint64_t>::max();
  return a > top / b ? top : a * b;
}

}  // namespace moivre
