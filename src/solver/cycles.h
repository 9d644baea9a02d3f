// SPDX-License-Identifier: MIT
// Which of the paths that wait after a turn around t = 1 are the sheets of one cycle? Those that
// lead to one another.
//
//   path p --one turn--> the point where path q waits --one turn--> ... --> the point where p
//   waits: m paths, winding number m
//
// Points over one t are known again by their hashes (point_hash.h). A path may have walked several
// turns, through sheets on which no path waits.
// Edges: a turn that leads to no waiting path, or to a point that two paths share, ends a chain
// that is not closed.
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

/// Positions in `turns`, in the order in which they lead to one another.
struct SheetChain {
  std::vector<std::size_t> sheets;
  bool is_closed = false;  ///< the last leads to the first, which is the smallest

  bool operator==(const SheetChain&) const = default;
};

/// Every position stands in one chain: first those that are closed.
std::vector<SheetChain> chains_of(const std::vector<Turn>& turns);

}  // namespace moivre
