// SPDX-License-Identifier: MIT
// Each degree from the one before it.
#include "local_polynomial.h"

namespace moivre {

std::vector<Exponents> monomials(std::size_t n, std::uint64_t k, std::size_t most) {
  std::vector<Exponents> all{Exponents(n)};
  std::size_t begin = 0;
  for (std::uint64_t d = 1; d <= k; ++d) {
    const std::size_t end = all.size();
    for (std::size_t i = begin; i < end; ++i) {
      // Each monomial once: a factor no earlier than the last one.
      std::size_t last = 0;
      for (std::size_t j = 0; j < n; ++j) {
        if (all[i][j] > 0) last = j;
      }
      for (std::size_t j = last; j < n; ++j) {
        Exponents next = all[i];
        ++next[j];
        all.push_back(std::move(next));
        if (all.size() > most) return {};
      }
    }
    begin = end;
  }
  return all;
}

}  // namespace moivre
