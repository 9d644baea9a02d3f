// SPDX-License-Identifier: MIT
// Does exact algebra give all simple roots of small systems, of whatever size, and nothing where it
// cannot?
#include "moivre/certify/ring_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

constexpr std::uint64_t kTerms = 100'000'000;

std::optional<std::vector<RingPoint>> points_of(const std::string& system,
                                                RingPointsOptions options = {}) {
  if (options.most_terms == 0) options.most_terms = kTerms;
  return ring_points(read_system({"test", system}), options);
}

/// The leading parts, by the first coordinate's real part.
std::vector<Point> leading_parts(const std::vector<RingPoint>& points) {
  std::vector<Point> result;
  for (const RingPoint& point : points) {
    Point& x = result.emplace_back();
    for (const auto& parts : point.x) x.push_back(parts.front());
  }
  std::sort(result.begin(), result.end(),
            [](const Point& a, const Point& b) { return a[0].real() < b[0].real(); });
  return result;
}

void expect_point(const Point& root, Complex x, Complex y) {
  EXPECT_NEAR(std::abs(root[0] - x), 0, 1e-15);
  EXPECT_NEAR(std::abs(root[1] - y), 0, 1e-15);
}

TEST(RingPoints, AreAllRootsWithAllCoordinates) {
  const auto points = points_of("2\nx^2 + y^2 - 5;\nx*y - 2;\n");
  ASSERT_TRUE(points);
  for (const RingPoint& point : *points) EXPECT_EQ(point.exponent, 1U);
  const std::vector<Point> roots = leading_parts(*points);
  ASSERT_EQ(roots.size(), 4U);
  const double x[] = {-2, -1, 1, 2};
  for (std::size_t k = 0; k < 4; ++k) expect_point(roots[k], x[k], 2 / x[k]);
}

TEST(RingPoints, TellHowOftenTheLineHasEach) {
  const auto points = points_of("2\n(x - 1)^2*(x^2 - 2)^3*(x - 3);\ny - x^2;\n");
  ASSERT_TRUE(points);
  std::multiset<std::uint64_t> exponents;
  for (const RingPoint& point : *points) {
    exponents.insert(point.exponent);
    const double x = point.x[0].front().real();
    EXPECT_DOUBLE_EQ(x, point.exponent == 1   ? 3
                        : point.exponent == 2 ? 1
                                              : std::copysign(std::sqrt(2), x));
    EXPECT_DOUBLE_EQ(point.x[1].front().real(), point.exponent == 3 ? 2 : x * x);
  }
  EXPECT_EQ(exponents, (std::multiset<std::uint64_t>{1, 2, 3, 3}));
}

// x^2 = y^2 = 0: four dimensions, and every line has the point twice.
TEST(RingPoints, MayBeMoreMultipleThanTheLineTells) {
  const auto points = points_of("2\nx^2;\ny^2;\n");
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 1U);
  EXPECT_LT(points->front().exponent, 4U);
}

TEST(RingPoints, HoldAnySizeBesideAnyOther) {
  const auto points = points_of("2\n(x - 10^30)*(10^30*x - 1);\ny*x - 1;\n");
  ASSERT_TRUE(points);
  const std::vector<Point> roots = leading_parts(*points);
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_DOUBLE_EQ(roots[0][0].real(), 1e-30);
  EXPECT_DOUBLE_EQ(roots[0][1].real(), 1e30);
  EXPECT_DOUBLE_EQ(roots[1][1].real(), 1e-30);
}

TEST(RingPoints, AreToldToMoreDigitsThanDoubleHas) {
  const auto points = points_of("1\nx^2 - 140*x + 4900 - 7e-46;\n");
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 2U);
  for (const RingPoint& point : *points) {
    ASSERT_GE(point.x[0].size(), 2U);
    EXPECT_EQ(point.x[0][0], 70.0);
    EXPECT_NEAR(std::abs(point.x[0][1]), 2.6457513110645906e-23, 1e-36);
  }
}

TEST(RingPoints, AreThoseOfASystemOfComplexCoefficientsNotOfItsConjugate) {
  const auto points = points_of("2\n(x - 2*i)*(x - 3 + i)*(x - 1)^2;\ny - i*x;\n");
  ASSERT_TRUE(points);
  const std::vector<Point> roots = leading_parts(*points);
  ASSERT_EQ(roots.size(), 3U);
  expect_point(roots[0], Complex(0, 2), -2);
  expect_point(roots[1], 1, Complex(0, 1));
  expect_point(roots[2], Complex(3, -1), Complex(1, 3));
}

TEST(RingPoints, AreTheSameWithAnySeed) {
  const std::string system = "3\nx^2 + y + z - 1;\nx + y^2 + z - 1;\nx + y + z^2 - 2;\n";
  const auto one = points_of(system, {.seed = 1});
  const auto other = points_of(system, {.seed = 99});
  ASSERT_TRUE(one && other);
  ASSERT_EQ(one->size(), 8U);
  for (const auto& [x, exponent] : *one) {
    EXPECT_EQ(std::count_if(other->begin(), other->end(),
                            [&x = x](const RingPoint& y) {
                              return std::abs(x[0][0] - y.x[0][0]) + std::abs(x[1][0] - y.x[1][0]) +
                                         std::abs(x[2][0] - y.x[2][0]) <
                                     1e-14;
                            }),
              1);
  }
}

TEST(RingPoints, AreNotFoundOnCurvesNorBeyondTheBudget) {
  EXPECT_FALSE(points_of("2\nx*y;\nx*(x - 1);\n"));
  EXPECT_FALSE(points_of("2\nx^2 + y^2 - 5;\nx*y - 2;\n", {.most_terms = 10}));
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(points_of("2\nx^3 + y^2 - 5;\nx*y^2 - 2*x;\n", {.stop = &stop}));
}

}  // namespace
}  // namespace moivre::test
