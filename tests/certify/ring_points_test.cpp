// SPDX-License-Identifier: MIT
// Does exact algebra give all simple roots of small systems, of whatever size, and nothing where it
// cannot?
#include "moivre/certify/ring_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

constexpr std::uint64_t kTerms = 100'000'000;

std::optional<RingPoints> points_of(const std::string& system, RingPointsOptions options = {}) {
  if (options.most_terms == 0) options.most_terms = kTerms;
  return ring_points(read_system({"test", system}), options);
}

/// The leading parts, by the first coordinate's real part.
std::vector<Point> leading_parts(const RingPoints& points) {
  std::vector<Point> result;
  for (const auto& coordinates : points.simple) {
    Point& x = result.emplace_back();
    for (const auto& parts : coordinates) x.push_back(parts.front());
  }
  std::sort(result.begin(), result.end(),
            [](const Point& a, const Point& b) { return a[0].real() < b[0].real(); });
  return result;
}

void expect_point(const Point& root, Complex x, Complex y) {
  EXPECT_NEAR(std::abs(root[0] - x), 0, 1e-15);
  EXPECT_NEAR(std::abs(root[1] - y), 0, 1e-15);
}

TEST(RingPoints, AreAllSimpleRootsWithAllCoordinates) {
  const auto points = points_of("2\nx^2 + y^2 - 5;\nx*y - 2;\n");
  ASSERT_TRUE(points);
  EXPECT_EQ(points->multiple, 0U);
  const std::vector<Point> roots = leading_parts(*points);
  ASSERT_EQ(roots.size(), 4U);
  const double x[] = {-2, -1, 1, 2};
  for (std::size_t k = 0; k < 4; ++k) expect_point(roots[k], x[k], 2 / x[k]);
}

TEST(RingPoints, LeaveOutMultipleOnesAndCountThem) {
  const auto points = points_of("2\n(x - 1)^2*(x - 3)*(x^2 + 1);\ny - x^2;\n");
  ASSERT_TRUE(points);
  EXPECT_EQ(points->simple.size(), 3U);
  EXPECT_EQ(points->multiple, 1U);
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
  ASSERT_EQ(points->simple.size(), 2U);
  for (const auto& coordinates : points->simple) {
    ASSERT_GE(coordinates[0].size(), 2U);
    EXPECT_EQ(coordinates[0][0], 70.0);
    EXPECT_NEAR(std::abs(coordinates[0][1]), 2.6457513110645906e-23, 1e-36);
  }
}

TEST(RingPoints, AreThoseOfASystemOfComplexCoefficientsNotOfItsConjugate) {
  const auto points = points_of("2\n(x - 2*i)*(x - 3 + i)*(x - 1)^2;\ny - i*x;\n");
  ASSERT_TRUE(points);
  EXPECT_EQ(points->multiple, 1U);
  const std::vector<Point> roots = leading_parts(*points);
  ASSERT_EQ(roots.size(), 2U);
  expect_point(roots[0], Complex(0, 2), -2);
  expect_point(roots[1], Complex(3, -1), Complex(1, 3));
}

TEST(RingPoints, AreTheSameWithAnySeed) {
  const std::string system = "3\nx^2 + y + z - 1;\nx + y^2 + z - 1;\nx + y + z^2 - 2;\n";
  const auto one = points_of(system, {.seed = 1});
  const auto other = points_of(system, {.seed = 99});
  ASSERT_TRUE(one && other);
  ASSERT_EQ(one->simple.size(), 8U);
  for (const auto& x : one->simple) {
    EXPECT_EQ(std::count_if(other->simple.begin(), other->simple.end(),
                            [&](const auto& y) {
                              return std::abs(x[0][0] - y[0][0]) + std::abs(x[1][0] - y[1][0]) +
                                         std::abs(x[2][0] - y[2][0]) <
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
