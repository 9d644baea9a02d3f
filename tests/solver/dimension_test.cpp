// SPDX-License-Identifier: MIT
// Is a curve of roots told from an isolated root, of whatever multiplicity up to 8?
#include "dimension.h"

#include <gtest/gtest.h>

#include <cmath>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

constexpr std::uint64_t kSeeds = 5;
/// What an endgame leaves of the digits of a singular end.
constexpr double kEndgameError = 1e-9;

System read(const std::string& text) { return read_system({"test", text}); }

void expect_on_set(const System& f, const Point& x, bool expected) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_EQ(lies_on_positive_dimensional_set(f, x, seed), expected) << "seed " << seed;
  }
}

TEST(DimensionTest, SeesTheCircleThatIsGivenTwice) {
  const System f = read("2\n x^2 + y^2 - 5;\n x^2 + y^2 - 5;\n");
  expect_on_set(f, {1, 2}, true);
  expect_on_set(f, {std::sqrt(5.0), 0}, true);
  expect_on_set(f, {3, Complex(0, 2)}, true);
}

TEST(DimensionTest, SeesACurveOfRootsThatIsDouble) {
  const System f = read("2\n (x^2 + y^2 - 5)^2;\n (x^2 + y^2 - 5)*(x - y);\n");
  expect_on_set(f, {1, 2}, true);
  expect_on_set(f, {2, -1}, true);
}

TEST(DimensionTest, SeesALineInSpace) {
  const System f = read("3\n x*y;\n x*z;\n x*(y + z - 1);\n");
  expect_on_set(f, {0, 3, -2}, true);
}

TEST(DimensionTest, TellsTheIsolatedRootBesideALine) {
  // (y - 1) times a line x = 0 and x (x - 2): the line x = 0 and the point (2, 1).
  const System f = read("2\n x*(y - 1)^2;\n x*(x - 2)^2;\n");
  expect_on_set(f, {0, 5}, true);
  expect_on_set(f, {2, 1}, false);
}

TEST(DimensionTest, SeesNoCurveAtAMultipleRootOfOneUnknown) {
  for (int m = 2; m <= 8; ++m) {
    SCOPED_TRACE("multiplicity " + std::to_string(m));
    const System f = read("2\n (x - 1)^" + std::to_string(m) + ";\n y - x^2;\n");
    expect_on_set(f, {1, 1}, false);
    expect_on_set(f, {1 + kEndgameError, 1 + 2 * kEndgameError}, false);
  }
}

TEST(DimensionTest, SeesNoCurveWhereTwoTangentCurvesMeet) {
  for (int m = 2; m <= 8; ++m) {
    SCOPED_TRACE("multiplicity " + std::to_string(m));
    const System f = read("2\n y - x^" + std::to_string(m) + ";\n y;\n");
    expect_on_set(f, {0, 0}, false);
    expect_on_set(f, {kEndgameError, kEndgameError}, false);
  }
}

TEST(DimensionTest, SeesNoCurveWhereTheJacobianVanishesAltogether) {
  expect_on_set(read("2\n x^2;\n y^2;\n"), {0, 0}, false);
  expect_on_set(read("3\n x^2 - y*z;\n y^2 - x*z;\n z^2 + x*y;\n"), {0, 0, 0}, false);
}

TEST(DimensionTest, KnowsThatOneUnknownHasNoCurves) {
  expect_on_set(read("1\n x^2;\n"), {0}, false);
}

}  // namespace
}  // namespace moivre
