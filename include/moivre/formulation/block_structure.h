// SPDX-License-Identifier: MIT
// In which order can a system be solved piece by piece? Its block triangular form: Assur groups,
// one after another.
//
// Equations are matched with unknowns (earlier equations first). The strongly connected components
// of the matching are the blocks, in an order in which each needs only the unknowns of blocks
// before it. Every block is square.
// Unmatched equations are structurally redundant: roots are checked on them. Unmatched unknowns are
// free, and so are all unknowns that an equation ties to a free one. The other blocks are
// determined without them.
// Source: [DulmageMendelsohn58], with Tarjan's algorithm for the pieces.
#pragma once

#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

struct Block {
  std::vector<std::size_t> equations;  ///< ascending
  std::vector<std::size_t> variables;  ///< ascending
  bool is_determined = true;           ///< no free unknown has a say in it
};

struct BlockStructure {
  std::vector<Block> blocks;
  std::vector<std::size_t> free_variables;
  std::vector<std::size_t> spare_equations;
};

BlockStructure block_structure(const System& f);

}  // namespace moivre
