// SPDX-License-Identifier: MIT
// Does the order of closures depend on their poses alone?
#include "moivre/closures/canonical_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace moivre {
namespace {

using Order = std::vector<std::size_t>;

const std::vector<Coordinate> kLengthAndAngle{{"x", CoordinateKind::length, 0},
                                              {"phi", CoordinateKind::angle, 0}};

Eigen::VectorXd pose(double x, double phi) { return Eigen::Vector2d(x, phi); }

TEST(CanonicalOrder, PutsTheLargerFirstCoordinateFirst) {
  EXPECT_EQ(canonical_order({pose(1, 3), pose(2, -3), pose(-4, 0)}, kLengthAndAngle, 1),
            (Order{1, 0, 2}));
}

TEST(CanonicalOrder, TakesRoundingInACoordinateForATieAndGoesOnToTheNext) {
  EXPECT_EQ(canonical_order({pose(1 + 1e-12, -1), pose(1, 1)}, kLengthAndAngle, 1), (Order{1, 0}));
  EXPECT_EQ(canonical_order({pose(1, -1), pose(1 + 1e-12, 1)}, kLengthAndAngle, 1), (Order{1, 0}));
}

TEST(CanonicalOrder, TakesBothNamesOfHalfATurnForOne) {
  const double half = std::numbers::pi;
  EXPECT_EQ(canonical_order({pose(1, 0), pose(1, -half + 1e-13)}, kLengthAndAngle, 1),
            (Order{1, 0}));
  EXPECT_EQ(canonical_order({pose(1, 0), pose(1, half - 1e-13)}, kLengthAndAngle, 1),
            (Order{1, 0}));
}

TEST(CanonicalOrder, MeasuresLengthsOnTheScaleOfTheLargest) {
  EXPECT_EQ(canonical_order({pose(1e9, -1), pose(1e9 + 1, 1)}, kLengthAndAngle, 1), (Order{1, 0}));
}

TEST(CanonicalOrder, TellsSmallPosesOfASmallMechanismApart) {
  EXPECT_EQ(canonical_order({pose(-1e-8, 0), pose(3e-8, 0)}, kLengthAndAngle, 3e-8), (Order{1, 0}));
  EXPECT_EQ(canonical_order({pose(-1e-8, 1), pose(3e-8, 0)}, kLengthAndAngle, 1), (Order{0, 1}));
}

TEST(CanonicalOrder, DoesNotDependOnTheOrderInWhichPosesCome) {
  std::vector<Eigen::VectorXd> poses{pose(1, 1), pose(1, -1), pose(2, 1), pose(0, 3)};
  std::vector<double> expected;
  for (const std::size_t k : canonical_order(poses, kLengthAndAngle, 1)) {
    expected.push_back(poses[k][0] + 10 * poses[k][1]);
  }
  std::reverse(poses.begin(), poses.end());
  std::vector<double> reversed;
  for (const std::size_t k : canonical_order(poses, kLengthAndAngle, 1)) {
    reversed.push_back(poses[k][0] + 10 * poses[k][1]);
  }
  EXPECT_EQ(reversed, expected);
}

TEST(CanonicalOrder, OfNothingIsNothing) {
  EXPECT_TRUE(canonical_order({}, kLengthAndAngle, 1).empty());
}

}  // namespace
}  // namespace moivre
