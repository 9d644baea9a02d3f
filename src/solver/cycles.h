// SPDX-License-Identifier: MIT
// Which of the paths that wait after one turn around t = 1 are the sheets of one cycle? Those that
// lead to one another.
//
//   path p --one turn--> the point where path q waits --one turn--> ... --> the point where p
//   waits: m paths, winding number m
//
// Points over one t are known again by their hashes (point_hash.h). Edges: a turn that leads to no
// waiting path, or to a point that two paths share, belongs to no cycle here: its path goes on
// alone.
#pragma once

#include <cstddef>
#include <vector>

#include "moivre/numeric/complex.h"

namespace moivre {

/// From hash to hash at one radius |1 - t|.
struct Turn {
  double radius = 0;
  Complex begin, end;
};

/// Positions in `turns`, in the order in which they lead to one another, the smallest first. Every
/// position stands in one cycle, alone if in no closed one of 2 to `most` sheets.
std::vector<std::vector<std::size_t>> cycles_of(const std::vector<Turn>& turns, std::size_t most);

}  // namespace moivre
