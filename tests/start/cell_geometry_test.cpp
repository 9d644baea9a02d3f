// SPDX-License-Identifier: MIT
// Are normals and weights the exact ones, rounded once?
#include "moivre/start/cell_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "families.h"

namespace moivre {
namespace {

/// x^2 + x y + 1 = 0 and y^3 + x = 0 with the lifting below, by hand.
MixedSubdivision by_hand() {
  MixedSubdivision s;
  s.supports = {Support{{{2, 0}, {1, 1}, {0, 0}}}, Support{{{0, 3}, {1, 0}}}};
  s.lifting = {{1, 9, 0}, {2, 0}};
  return s;
}

TEST(CellGeometry, NormalAndWeightsOfACellByHand) {
  const MixedSubdivision s = by_hand();
  const MixedCell cell{{{0, 2}, {0, 1}}, 6};
  // 2 a = -1 from the first edge, 3 b + 2 = a from the second: a = -1/2, b = -5/6.
  EXPECT_EQ(inner_normal(s, cell), (std::vector<Rational>{Rational(-1, 2), Rational(-5, 6)}));
  // Term x y: 9 - 1/2 - 5/6 = 23/3 above the edge at 0.
  const std::vector<Rational> exact{0, Rational(23, 3), 0, 0, 0};
  EXPECT_EQ(exact_cell_weights(s, cell), exact);
  EXPECT_EQ(cell_weights(s, cell), (std::vector<double>{0, 23.0 / 3, 0, 0, 0}));
  EXPECT_EQ(edge_matrix(s, cell), (std::vector<std::int64_t>{-2, 0, 1, -3}));
}

TEST(CellGeometry, DoublesAreTheExactWeightsRoundedOnce) {
  // The stretched system needs long words; weights are the same up to the common lifting.
  const MixedSubdivision s = *mixed_cells(stretched(cyclic(5), 1999), 5).subdivision;
  for (const MixedCell& cell : s.cells) {
    const std::vector<Rational> exact = exact_cell_weights(s, cell);
    const std::vector<double> rounded = cell_weights(s, cell);
    ASSERT_EQ(exact.size(), rounded.size());
    for (std::size_t k = 0; k < exact.size(); ++k) EXPECT_EQ(rounded[k], to_double(exact[k]));
  }
}

TEST(CellGeometry, TheLeastPositiveWeightLeavesOutTheEdges) {
  EXPECT_EQ(least_positive_weight(std::vector<double>{0, 3, 0.5, 0}), 0.5);
  EXPECT_TRUE(std::isinf(least_positive_weight(std::vector<double>{0, 0})));
}

TEST(CellGeometry, RefusesACellWithoutVolumeOrOfOtherSupports) {
  const MixedSubdivision s = by_hand();
  EXPECT_THROW(cell_weights(s, MixedCell{{{0, 0}, {0, 1}}, 0}), std::invalid_argument);
  EXPECT_THROW(cell_weights(s, MixedCell{{{0, 7}, {0, 1}}, 0}), std::invalid_argument);
  EXPECT_THROW(inner_normal(s, MixedCell{{{0, 2}}, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
