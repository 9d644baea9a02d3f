// SPDX-License-Identifier: MIT
// In which order can a system be solved piece by piece? Its block triangular form: Assur groups, one after another.
//
// Equations are matched with unknowns (earlier equations first); the strongly connected pieces of the matching, in the
// order in which each needs only the unknowns of pieces before it, are the blocks. Every block is square.
// Equations left over say nothing new, structurally: roots are checked on them. Unknowns left over are
// free, and so are all that an equation ties to a free one; the other blocks are determined without them.
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
