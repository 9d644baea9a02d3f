// SPDX-License-Identifier: MIT
// Is the multiplicity of a root that is known exactly counted exactly, and is nothing said where
// nothing is known?
#include "moivre/algebra/local_multiplicity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "moivre/numeric/complex.h"
#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

std::vector<Coefficient> exact(const Point& x) {
  std::vector<Coefficient> result;
  for (const Complex& xi : x) result.push_back({Rational(xi.real()), Rational(xi.imag())});
  return result;
}

std::optional<std::uint64_t> multiplicity(const std::string& text, const Point& x) {
  return local_multiplicity(read_system({"test", text}), exact(x));
}

LocalRing ring(const std::string& text, const Point& x) {
  return local_ring(read_system({"test", text}), exact(x)).value_or(LocalRing{});
}

TEST(LocalMultiplicity, IsTheProductOfTheDegreesForPowers) {
  EXPECT_EQ(multiplicity("2\n x^2;\n y^2;\n", {0, 0}), 4U);
  EXPECT_EQ(multiplicity("2\n x^2;\n y^3;\n", {0, 0}), 6U);
  EXPECT_EQ(multiplicity("3\n x^2;\n y^2;\n z^2;\n", {0, 0, 0}), 8U);
  EXPECT_EQ(multiplicity("2\n x^2 - y^3;\n x^3;\n", {0, 0}), 9U);
}

// [DaytonZeng05] and the literature it collects.
TEST(LocalMultiplicity, OfPublishedSystems) {
  EXPECT_EQ(multiplicity("2\n 29/16*x^3 - 2*x*y;\n y - x^2;\n", {0, 0}), 3U);
  EXPECT_EQ(multiplicity("2\n x^2 + y - 3;\n x + 1/8*y^2 - 3/2;\n", {1, 2}), 3U);
  EXPECT_EQ(multiplicity("3\n x^2*y - x*y^2;\n x - y^2;\n z;\n", {0, 0, 0}), 4U);
}

TEST(LocalMultiplicity, OfASimpleRootIsOne) {
  EXPECT_EQ(multiplicity("2\n x^2 + y^2 - 2;\n x - y;\n", {1, 1}), 1U);
  EXPECT_EQ(multiplicity("1\n x^2 + 1;\n", {Complex(0, 1)}), 1U);
}

TEST(LocalMultiplicity, IsThatOfTheRootAlone) {
  EXPECT_EQ(multiplicity("1\n (x - 3)^4*(x + 1)*x^2;\n", {3}), 4U);
  EXPECT_EQ(multiplicity("1\n (x - 3)^4*(x + 1)*x^2;\n", {0}), 2U);
  EXPECT_EQ(multiplicity("1\n (x^2 + 1)^3;\n", {Complex(0, -1)}), 3U);
  // A simple root 2e-12 away does not count.
  EXPECT_EQ(multiplicity("2\n y^2 - 5095*x^2*y;\n x + 9823*y;\n", {0, 0}), 2U);
}

TEST(LocalMultiplicity, SaysNothingOfAPointThatIsNoRoot) {
  EXPECT_FALSE(multiplicity("2\n x^2;\n y^2;\n", {1e-30, 0}));
  // A prime of 61 bits.
  EXPECT_FALSE(multiplicity("1\n x^2 - 2305843009213693921;\n", {0}));
}

TEST(LocalMultiplicity, SaysNothingOfARootThatIsNotIsolated) {
  EXPECT_FALSE(multiplicity("2\n x*y;\n x^2;\n", {0, 0}));
  EXPECT_FALSE(multiplicity("2\n x^2 + y^2 - 5;\n (x^2 + y^2 - 5)*x;\n", {1, 2}));
}

TEST(LocalRing, OfACurveGrowsByItsMultiplicityAtEachStep) {
  // A line, with an embedded point at 0; a node; three lines.
  for (const char* text :
       {"2\n x*y;\n x^2;\n", "1 2\n y^2 - x^2 - x^3;\n", "3\n x*y;\n y*z;\n x*z;\n"}) {
    const LocalRing of_curve = ring(text, Point(text[0] == '3' ? 3 : 2));
    EXPECT_TRUE(of_curve.grows_steadily) << text;
    EXPECT_FALSE(of_curve.is_isolated) << text;
  }
}

TEST(LocalRing, OfAnIsolatedRootHasNoMoreDimensionsThanItsMultiplicity) {
  const LocalRing looked_through = ring("2\n x^2;\n y^3;\n", {0, 0});
  EXPECT_TRUE(looked_through.is_isolated);
  EXPECT_EQ(looked_through.dimension, 6U);
  // 1600, beyond what is looked at: at each step one more than before.
  const LocalRing too_large = ring("2\n x^40;\n y^40;\n", {0, 0});
  EXPECT_FALSE(too_large.is_isolated);
  EXPECT_FALSE(too_large.grows_steadily);
  EXPECT_GT(too_large.dimension, 100U);
  EXPECT_LE(too_large.dimension, 1600U);
}

// One unknown has as many degrees as columns: a matrix for each of them takes hundreds of times as
// long as the last one.
TEST(LocalRing, OfOneUnknownTakesAboutAsLongAsOfTwo) {
  const auto seconds = [](const std::string& text, std::size_t n) {
    const System f = read_system({"test", text});
    const auto begin = std::chrono::steady_clock::now();
    const LocalRing full = local_ring(f, exact(Point(n))).value_or(LocalRing{});
    EXPECT_FALSE(full.is_isolated);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  double one = kNever, two = kNever;
  for (int times = 0; times < 3; ++times) {
    one = std::min(one, seconds("1\n x^700;\n", 1));
    two = std::min(two, seconds("2\n x^40;\n y^40;\n", 2));
  }
  EXPECT_LT(one, 10 * two);  // alike; it was 64 times
}

// Of every multiplicity, wherever the degrees that are looked at lie.
TEST(LocalMultiplicity, IsFoundAtEveryDegree) {
  for (std::uint64_t m = 1; m <= 120; ++m) {
    EXPECT_EQ(multiplicity("1\n x^" + std::to_string(m) + ";\n", {0}), m);
  }
  EXPECT_EQ(multiplicity("1\n x^499;\n", {0}), 499U);
  EXPECT_FALSE(multiplicity("1\n x^500;\n", {0}));
  for (std::uint64_t m = 1; m <= 14; ++m) {
    const std::string power = std::to_string(m);
    EXPECT_EQ(multiplicity("2\n x^" + power + ";\n y^" + power + ";\n", {0, 0}), m * m);
  }
}

TEST(LocalMultiplicity, GivesUpWhereThePowersAreTooHigh) {
  EXPECT_FALSE(multiplicity("1\n x^4294967295;\n", {0}));
  EXPECT_FALSE(multiplicity("2\n x^40;\n y^40;\n", {0, 0}));
}

}  // namespace
}  // namespace moivre
