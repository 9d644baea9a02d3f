// SPDX-License-Identifier: MIT
// The rows as they come, columns by first appearance.
#include "modular_rank.h"

#include <algorithm>
#include <map>

#include "moivre/polynomial/modular.h"

namespace moivre {

std::size_t modular_rank(const std::vector<const IntegerPolynomial*>& rows, std::uint64_t degree,
                         const std::atomic<bool>* stop) {
  std::map<Monomial, std::size_t, MonomialOrder> columns;
  const PrimeField field;
  ModularRows reduced(field);
  for (const IntegerPolynomial* p : rows) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) break;
    ModularRow row;
    for (const auto& [m, c] : p->terms) {
      if (moivre::degree(m) != degree) continue;
      const std::size_t column = columns.try_emplace(m, columns.size()).first->second;
      const Residue value = field.residue(c);
      if (value != 0) row.emplace_back(column, value);
    }
    std::sort(row.begin(), row.end());
    reduced.add(row);
  }
  return reduced.rank();
}

}  // namespace moivre
