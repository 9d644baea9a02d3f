// SPDX-License-Identifier: MIT
// Which start root has path `number`? The cell it belongs to, and its number there, by sums over
// the cells before.
//
// A cell has as many paths as its volume; cells come in the order of the subdivision. A search
// takes log2(cells) steps.
// Edges: a path number that no cell has: std::out_of_range.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "moivre/start/mixed_cells.h"

namespace moivre {

struct PathIndex {
  std::vector<std::uint64_t> end;  ///< of each cell: number of its last path + 1

  std::uint64_t paths() const { return end.empty() ? 0 : end.back(); }
};

struct StartRoot {
  std::size_t cell = 0;
  std::uint64_t root = 0;  ///< 0 <= root < volume of the cell

  friend bool operator==(const StartRoot&, const StartRoot&) = default;
};

/// Throws std::overflow_error when the volumes add up beyond 64 bits.
PathIndex make_path_index(const std::vector<MixedCell>& cells);

StartRoot start_root(const PathIndex& index, std::uint64_t number);

}  // namespace moivre
