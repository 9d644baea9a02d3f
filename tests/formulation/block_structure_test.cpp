// SPDX-License-Identifier: MIT
// Are systems taken apart in an order in which they can be solved?
#include "moivre/formulation/block_structure.h"

#include <gtest/gtest.h>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

BlockStructure structure_of(const std::string& equations) {
  return block_structure(read_system({"f.phc", equations}));
}

TEST(BlockStructure, SolvesWhatIsNeededFirst) {
  const BlockStructure structure = structure_of("2\nx*y - 1;\nx^2 - 2;\n");
  ASSERT_EQ(structure.blocks.size(), 2u);
  EXPECT_EQ(structure.blocks[0].equations, (std::vector<std::size_t>{1}));
  EXPECT_EQ(structure.blocks[0].variables, (std::vector<std::size_t>{0}));
  EXPECT_EQ(structure.blocks[1].variables, (std::vector<std::size_t>{1}));
}

TEST(BlockStructure, KeepsTogetherWhatIsCoupled) {
  const BlockStructure structure = structure_of("2\nx + y - 3;\nx*y - 2;\n");
  ASSERT_EQ(structure.blocks.size(), 1u);
  EXPECT_EQ(structure.blocks[0].variables.size(), 2u);
}

TEST(BlockStructure, SparesTheLastOfTooManyEquations) {
  const BlockStructure structure = structure_of("3 2\nx - 1;\ny - 2;\nx + y - 3;\n");
  EXPECT_EQ(structure.blocks.size(), 2u);
  EXPECT_EQ(structure.spare_equations, (std::vector<std::size_t>{2}));
}

TEST(BlockStructure, NamesFreeVariables) {
  const BlockStructure structure = structure_of("1 2\nx + y - 1;\n");
  EXPECT_EQ(structure.free_variables.size(), 1u);
}

TEST(BlockStructure, DeterminesWhatNoFreeVariableHasASayIn) {
  const BlockStructure structure = structure_of("2 3\nx^2 - 2;\ny + z - x;\n");
  ASSERT_EQ(structure.blocks.size(), 2u);
  for (const Block& block : structure.blocks) {
    EXPECT_EQ(block.is_determined, block.equations == std::vector<std::size_t>{0});
  }
}

}  // namespace
}  // namespace moivre
