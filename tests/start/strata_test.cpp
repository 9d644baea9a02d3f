// SPDX-License-Identifier: MIT
// Do the strata bound the points of isolated roots, and as sharply as roots that are counted by
// hand?
#include "moivre/start/strata.h"

#include <gtest/gtest.h>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

std::optional<std::uint64_t> points(const std::string& text, std::uint64_t seed = 1) {
  return most_isolated_points(read_system({"test", text}), seed);
}

// x (a y + ...): each factor is 0 or the other: 1 + 1 + 1 + 1.
TEST(Strata, OfRateEquationsAddUp) {
  EXPECT_EQ(points("2\nx^2 + x*y - x;\ny^2 + 2*x*y - y;\n"), 4U);
  EXPECT_EQ(points("3\nx*(1 - x - 2*y - 3*z);\ny*(2 - 3*x - y - 5*z);\nz*(3 - 7*x - 2*y - z);\n"),
            8U);
}

TEST(Strata, ARootAtZeroIsOnePointWhateverItsMultiplicity) {
  EXPECT_EQ(points("2\nx^3 - 2*y^4;\ny^2 - 5*x^3;\n"), 7U);  // the origin, and 6 roots beside it
  EXPECT_EQ(points("1\nx^7 - x^5;\n"), 3U);
}

// x = 0 is a line of roots, and 0 lies on it. Two others solve the system without the factor.
TEST(Strata, OfALineOfRootsHaveNoIsolatedOnes) {
  const char* text = "2\n1322*x^2*y + 7232*x*y^2 - 783*x^2 - x*y;\n-9213*x^2*y + 6*x*y^2 + x*y;\n";
  for (std::uint64_t seed = 1; seed <= 5; ++seed) EXPECT_EQ(points(text, seed), 2U);
}

// On x = 0 one equation in y and z is left, a curve of roots; it passes through 0.
TEST(Strata, WhereEquationsAreFewerThanUnknownsNoRootIsIsolated) {
  EXPECT_EQ(points("3\nx*(y - 2);\nx*(z - 3);\ny + z - 2*x + y*z;\n"), 1U);
}

TEST(Strata, OfEquationsWithConstantsAreOneMixedVolume) {
  EXPECT_EQ(points("2\nx^2 + y^2 - 5;\nx*y - 2;\n"), 4U);
}

// Where x = 0 all three equations in y and z have the root (1, 1).
TEST(Strata, ARootThatTooManyEquationsShareLeavesNothingKnown) {
  EXPECT_FALSE(points("3\ny + z - 2 + x^2;\ny*z - 1 + 3*x;\ny^2 + z - 2 + x*y;\n"));
}

TEST(Strata, AboveWhatIsAskedForNothingIsTold) {
  const System f = read_system({"test", "2\nx^2 + x*y - x;\ny^2 + 2*x*y - y;\n"});
  EXPECT_FALSE(most_isolated_points(f, 1, {}, 3));
  EXPECT_EQ(most_isolated_points(f, 1, {}, 4), 4U);
}

TEST(Strata, OfMoreThanADozenUnknownsAreNotCounted) {
  std::string text = "13\n";
  for (int j = 1; j <= 13; ++j) {
    text += "x" + std::to_string(j) + "^2 - x" + std::to_string(j) + ";\n";
  }
  EXPECT_FALSE(points(text));
}

}  // namespace
}  // namespace moivre
