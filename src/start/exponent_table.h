// SPDX-License-Identifier: MIT
// In how many ways can the equations left take the factors left? c(r) for all r <= (n_1, ..., n_k),
// in any kind of count.
// Private to the module.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "moivre/start/multihomogeneous.h"

namespace moivre {

/// Places of the vectors r in a table, r_1 counted fastest.
struct ExponentTable {
  std::vector<std::uint64_t> sizes;    ///< n_j
  std::vector<std::uint64_t> strides;  ///< prod_{l<j} (n_l + 1)
  std::uint64_t entries = 1;
};

/// nullopt where there are more than kMaximumTable entries.
std::optional<ExponentTable> exponent_table(const Partition& groups);

/// c(0) = one; c(r) = sum of times(d_ij, c(r - e_j)) by plus, i = n - |r|. degree(i, j): d_ij;
/// where it is 0 nothing is added.
template <class Count, class Degree, class Times, class Plus>
std::vector<Count> completions(const ExponentTable& shape, Count one, Degree degree, Times times,
                               Plus plus) {
  std::uint64_t left = 0;  // n - |r|
  for (const std::uint64_t size : shape.sizes) left += size;
  std::vector<Count> table(shape.entries, Count(0));
  table[0] = one;
  std::vector<std::uint64_t> r(shape.sizes.size(), 0);
  for (std::uint64_t at = 1; at < shape.entries; ++at) {
    std::size_t digit = 0;
    for (; r[digit] == shape.sizes[digit]; ++digit) {
      left += r[digit];
      r[digit] = 0;
    }
    ++r[digit];
    --left;
    for (std::size_t j = 0; j < r.size(); ++j) {
      if (r[j] == 0) continue;
      const std::uint64_t d = degree(left, j);
      if (d > 0) table[at] = plus(table[at], times(d, table[at - shape.strides[j]]));
    }
  }
  return table;
}

}  // namespace moivre
