// SPDX-License-Identifier: MIT
// Are bounds on roots those of the literature, and found no further than is needed?
#include "moivre/bounds/root_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

System system_of(const std::string& text) { return read_system({"test", text}); }

System problem(const std::string& name) {
  return read_system(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/polynomials/" + name + ".phc"));
}

TEST(RootBounds, OfCassouAreThePublishedOnes) {
  const std::vector<RootBound> bounds = root_bounds(problem("cassou"), {});
  ASSERT_EQ(bounds.size(), 4U);
  EXPECT_EQ(bounds[0].value, 1344U);
  EXPECT_LT(bounds[1].value, 1344U);
  EXPECT_EQ(bounds[2].kind, BoundKind::stable_mixed_volume);
  EXPECT_EQ(bounds[2].value, 24U);
  EXPECT_EQ(bounds[3].kind, BoundKind::quotient_ring);
  EXPECT_EQ(bounds[3].value, 16U);
}

TEST(RootBounds, EndWithTheFirstThatIsMet) {
  const System f = system_of("2\nx^2 + y^2 - 5;\nx*y - 2;\n");
  const std::vector<RootBound> bounds = root_bounds(f, {4, 4});
  ASSERT_EQ(bounds.size(), 1U);
  EXPECT_EQ(bounds[0].kind, BoundKind::bezout);
  EXPECT_EQ(bounds[0].value, 4U);
  EXPECT_EQ(root_bounds(f, {3, 3}).size(), 4U);
}

TEST(RootBounds, CountRootsWithZeroCoordinates) {
  const std::vector<RootBound> bounds =
      root_bounds(system_of("2\nx^2 + x*y - x;\ny^2 + 2*x*y - y;\n"), {});
  ASSERT_EQ(bounds.size(), 5U);
  EXPECT_EQ(bounds[2].value, 4U);  // (0,0), (1,0), (0,1), and one more
  EXPECT_EQ(bounds[3].kind, BoundKind::quotient_ring);
  EXPECT_EQ(bounds[3].value, 4U);
  EXPECT_EQ(bounds[4].kind, BoundKind::strata);
  EXPECT_EQ(bounds[4].value, 4U);
}

TEST(RootBounds, OfPointsAreMetByPointsAndOthersByMultiplicities) {
  const System f = system_of("2\nx^3 - 2*y^4;\ny^2 - 5*x^3;\n");
  EXPECT_EQ(root_bounds(f, {12, 7}).size(), 1U);  // 6 roots, and the origin six times
  const std::vector<RootBound> bounds = root_bounds(f, {7, 7});
  EXPECT_EQ(bounds.back().kind, BoundKind::strata);
  EXPECT_EQ(bounds.back().value, 7U);
}

TEST(RootBounds, TellThatTheQuotientRingIsInfiniteWhereRootsLieOnCurves) {
  const std::vector<RootBound> bounds = root_bounds(system_of("2\nx^2*y - x;\nx*y^2 - 3*x;\n"), {});
  const auto ring = std::find_if(bounds.begin(), bounds.end(), [](const RootBound& bound) {
    return bound.kind == BoundKind::quotient_ring;
  });
  ASSERT_NE(ring, bounds.end());
  EXPECT_FALSE(ring->value);
  EXPECT_EQ(ring->missing, "infinite: some roots lie on curves");
}

TEST(RootBounds, AreToldByEliminationWhereThatDecides) {
  const auto alone = [](const std::string& text) {
    const std::vector<RootBound> bounds = root_bounds(system_of(text), {});
    EXPECT_EQ(bounds.size(), 1U);
    EXPECT_EQ(bounds[0].kind, BoundKind::elimination);
    return bounds[0].value;
  };
  EXPECT_EQ(alone("2\nx + y - 3;\nx - y - 1;\n"), 1U);
  EXPECT_EQ(alone("2\nx + y - 3;\nx + y - 1;\n"), 0U);
  EXPECT_EQ(alone("2\nx*y - 3;\n2*x*y - 6;\n"), 0U);
}

TEST(RootBounds, AreRefusedWhereASystemIsNotSquare) {
  EXPECT_THROW(root_bounds(system_of("1 2\nx + y;\n"), {}), std::invalid_argument);
}

TEST(StructureCounts, AreThoseOfTheStarts) {
  const StructureCounts counts = structure_counts(problem("cassou"), true, true);
  EXPECT_EQ(counts.mixed_volume, 24U);
  EXPECT_FALSE(structure_counts(problem("cassou"), true, false).mixed_volume);
}

}  // namespace
}  // namespace moivre::test
