// SPDX-License-Identifier: MIT
// Path numbers and the cells they belong to.
#include "moivre/start/path_index.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace moivre {

PathIndex make_path_index(const std::vector<MixedCell>& cells) {
  PathIndex index;
  std::uint64_t sum = 0;
  for (const MixedCell& cell : cells) {
    if (cell.volume > std::numeric_limits<std::uint64_t>::max() - sum) {
      throw std::overflow_error("the volumes of the cells add up beyond 64 bits");
    }
    sum += cell.volume;
    index.end.push_back(sum);
  }
  return index;
}

StartRoot start_root(const PathIndex& index, std::uint64_t number) {
  const auto cell = std::upper_bound(index.end.begin(), index.end.end(), number);
  if (cell == index.end.end()) {
    throw std::out_of_range("path " + std::to_string(number) + " of " +
                            std::to_string(index.paths()));
  }
  const std::uint64_t before = cell == index.end.begin() ? 0 : *(cell - 1);
  return {static_cast<std::size_t>(cell - index.end.begin()), number - before};
}

}  // namespace moivre
