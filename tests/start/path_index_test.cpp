// SPDX-License-Identifier: MIT
// Does every path number belong to one root of one cell?
#include "moivre/start/path_index.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace moivre {
namespace {

TEST(PathIndex, CountsThroughTheRootsOfTheCells) {
  const PathIndex index = make_path_index({{{}, 3}, {{}, 1}, {{}, 4}});
  ASSERT_EQ(index.paths(), 8u);
  std::uint64_t number = 0;
  for (const std::uint64_t volume : {3u, 1u, 4u}) {
    const std::size_t cell = number == 0 ? 0 : number == 3 ? 1 : 2;
    for (std::uint64_t root = 0; root < volume; ++root) {
      EXPECT_EQ(start_root(index, number++), (StartRoot{cell, root}));
    }
  }
}

TEST(PathIndex, RefusesANumberThatNoCellHas) {
  EXPECT_THROW(start_root(make_path_index({{{}, 3}}), 3), std::out_of_range);
  EXPECT_THROW(start_root(make_path_index({}), 0), std::out_of_range);
  EXPECT_EQ(make_path_index({}).paths(), 0u);
}

TEST(PathIndex, SeesASumBeyond64Bits) {
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(make_path_index({{{}, most - 1}, {{}, 1}}).paths(), most);
  EXPECT_THROW(make_path_index({{{}, most}, {{}, 1}}), std::overflow_error);
}

}  // namespace
}  // namespace moivre
