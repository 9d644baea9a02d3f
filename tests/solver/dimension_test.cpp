// SPDX-License-Identifier: MIT
// Is a set of roots told from an isolated root: smooth, multiple, crossing itself; and the root
// from a set nearby?
#include "dimension.h"

#include <gtest/gtest.h>

#include <cmath>

#include "moivre/numeric/random.h"
#include "moivre/polynomial/read.h"
#include "problem_set.h"

namespace moivre {
namespace {

constexpr std::uint64_t kSeeds = 50;
/// What endgames leave of the digits of a singular end.
constexpr double kEndgameErrors[] = {0, 1e-5};
/// To which such an end is known.
constexpr double kKnownTo = 1e-4;

using test::read;

/// At x and, by each of the errors, beside it.
void expect_on_set(const System& f, const Point& x, bool expected) {
  const RefinerProgram program(f, std::vector<double>(x.size(), 1.0));
  for (const double error : kEndgameErrors) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      Point end = x;
      for (std::size_t i = 0; i < x.size(); ++i) {
        end[i] += error * random_phase(seed, RandomStream::test, i);
      }
      EXPECT_EQ(set_through(program, end, kKnownTo, seed) != SetHere::none, expected)
          << "seed " << seed << ", error " << error;
    }
  }
}

TEST(DimensionTest, SeesTheCircleThatIsGivenTwice) {
  const System f = read("2\n x^2 + y^2 - 5;\n x^2 + y^2 - 5;\n");
  expect_on_set(f, {1, 2}, true);
  expect_on_set(f, {std::sqrt(5.0), 0}, true);
  expect_on_set(f, {3, Complex(0, 2)}, true);
}

TEST(DimensionTest, SeesACircleSmallBesideItsSteps) {
  const System f = read("2\n x^2 + y^2 - 1/100;\n (x^2 + y^2 - 1/100)*(x + y + 1);\n");
  expect_on_set(f, {0.06, 0.08}, true);
}

TEST(DimensionTest, SeesACurveOfRootsThatIsMultiple) {
  const System f = read("2\n (x^2 + y^2 - 5)^2;\n (x^2 + y^2 - 5)*(x - y);\n");
  expect_on_set(f, {1, 2}, true);
  expect_on_set(f, {2, -1}, true);
  expect_on_set(f, {std::sqrt(2.5), std::sqrt(2.5)}, true);
  expect_on_set(read("2\n x^4;\n x^4*(y - 4);\n"), {0, 1}, true);
}

TEST(DimensionTest, SeesASetWhoseCoefficientsWereRounded) {
  const System f = read("2\n x^2 + y^2 - 5;\n x^2 + y^2 - 5.0000000000000002;\n");
  expect_on_set(f, {1, 2}, true);
}

// On the first, which no digits take away, F vanishes; on the second it is as small as the
// coefficients' rounding.
TEST(DimensionTest, TellsASetFromOneThatIsThereAsRoundedOnly) {
  const std::vector<double> unit{1, 1};
  const RefinerProgram circle(read("2\n x^2 + y^2 - 5;\n (x^2 + y^2 - 5)*(x + 7);\n"), unit);
  const RefinerProgram nearly(read("2\n x^2 + y^2 - 5;\n x^2 + y^2 - 5.0000000000000002;\n"), unit);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_EQ(set_through(circle, {1, 2}, kKnownTo, seed), SetHere::sharp) << seed;
    EXPECT_EQ(set_through(nearly, {1, 2}, kKnownTo, seed), SetHere::blurred) << seed;
  }
}

TEST(DimensionTest, SeesALineInSpace) {
  const System f = read("3\n x*y;\n x*z;\n x*(y + z - 1);\n");
  expect_on_set(f, {0, 3, -2}, true);
}

TEST(DimensionTest, SeesTheLinesThatCross) {
  expect_on_set(read("2\n x*y;\n x^2*y + x*y^2;\n"), {0, 0}, true);
  expect_on_set(read("2\n (x - 3)*(y + 2);\n (x - 3)*(y + 2)*(x + y);\n"), {3, -2}, true);
  expect_on_set(read("3\n x*y;\n y*z;\n z*x;\n"), {0, 0, 0}, true);
  expect_on_set(read("3\n x^2 - y^2;\n z*(x - 1);\n z*(z + y + 4);\n"), {0, 0, 0}, true);
}

TEST(DimensionTest, SeesTheSurfacesThatCross) {
  expect_on_set(read("3\n x^2 - y^2;\n z*(x^2 - y^2);\n x*(x^2 - y^2);\n"), {0, 0, 1}, true);
  // Whitney's umbrella: at its pinch point, on its double line.
  const System umbrella = read("3\n x^2 - y^2*z;\n (x^2 - y^2*z)*x;\n (x^2 - y^2*z)*(y - 1);\n");
  expect_on_set(umbrella, {0, 0, 0}, true);
  expect_on_set(umbrella, {0, 0, 2}, true);
}

TEST(DimensionTest, SeesTheCurvesThroughTheirOwnSingularPoints) {
  expect_on_set(read("2\n x^3 - y^2;\n x*(x^3 - y^2);\n"), {0, 0}, true);
  expect_on_set(read("2\n y^2 - x^2*(x + 1);\n (y^2 - x^2*(x + 1))*(x + y);\n"), {0, 0}, true);
  expect_on_set(read("2\n y*(y - x^4);\n y*(y - x^4)*(x + 2);\n"), {0, 0}, true);
}

TEST(DimensionTest, SeesTheSetAboutItsEmbeddedPoints) {
  expect_on_set(read("2\n x^2;\n x*y;\n"), {0, 0}, true);
  expect_on_set(read("2\n x^2;\n x*y^3;\n"), {0, 0}, true);
  const System cyclic_4 = read(
      "4\n a + b + c + d;\n a*b + b*c + c*d + d*a;\n a*b*c + b*c*d + c*d*a + d*a*b;\n"
      " a*b*c*d - 1;\n");
  const Complex i(0, 1);
  expect_on_set(cyclic_4, {1, -1, -1, 1}, true);
  expect_on_set(cyclic_4, {i, i, -i, -i}, true);
}

TEST(DimensionTest, TellsTheIsolatedRootBesideALine) {
  // The line x = 0 and the point (d, 1).
  for (const char* d : {"2", "0.5", "0.1", "0.02"}) {
    SCOPED_TRACE(std::string("distance ") + d);
    const System f = read(std::string("2\n x*(y - 1)^2;\n x*(x - ") + d + ")^2;\n");
    expect_on_set(f, {0, 5}, true);
    expect_on_set(f, {0, 1}, true);
    expect_on_set(f, {std::stod(d), 1}, false);
  }
}

TEST(DimensionTest, SeesNoCurveAtAMultipleRootOfOneUnknown) {
  for (int m = 2; m <= 12; ++m) {
    SCOPED_TRACE("multiplicity " + std::to_string(m));
    const System f = read("2\n (x - 1)^" + std::to_string(m) + ";\n y - x^2;\n");
    expect_on_set(f, {1, 1}, false);
  }
}

TEST(DimensionTest, SeesNoCurveWhereTwoTangentCurvesMeet) {
  for (int m = 2; m <= 12; ++m) {
    SCOPED_TRACE("multiplicity " + std::to_string(m));
    const System f = read("2\n y - x^" + std::to_string(m) + ";\n y;\n");
    expect_on_set(f, {0, 0}, false);
  }
}

TEST(DimensionTest, SeesNoCurveWhereTheJacobianVanishesAltogether) {
  expect_on_set(read("2\n x^2;\n y^2;\n"), {0, 0}, false);
  expect_on_set(read("2\n x^2;\n y^3;\n"), {0, 0}, false);
  expect_on_set(read("2\n x^4;\n y^4;\n"), {0, 0}, false);
  expect_on_set(read("2\n x^2 - y^3;\n x^3;\n"), {0, 0}, false);
  expect_on_set(read("3\n x^2;\n y^2;\n z^2;\n"), {0, 0, 0}, false);
  expect_on_set(read("3\n x^2 - y*z;\n y^2 - x*z;\n z^2 + x*y;\n"), {0, 0, 0}, false);
}

TEST(DimensionTest, MeasuresInTheUnitsOfTheUnknowns) {
  const RefinerProgram crossing(
      read("2\n (1e6*x - 1)*(y - 1e6);\n (1e6*x - 1)*(y - 1e6)*(1e6*x + 1e-6*y);\n"), {1e-6, 1e6});
  const RefinerProgram isolated(read("2\n (1e6*x - 1)^2;\n (1e-6*y - 1)^2;\n"), {1e-6, 1e6});
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_NE(set_through(crossing, {1e-6, 1e6}, kKnownTo, seed), SetHere::none) << seed;
    EXPECT_EQ(set_through(isolated, {1e-6, 1e6}, kKnownTo, seed), SetHere::none) << seed;
  }
}

TEST(DimensionTest, KnowsThatOneUnknownHasNoCurves) {
  expect_on_set(read("1\n x^2;\n"), {0}, false);
}

}  // namespace
}  // namespace moivre
