// SPDX-License-Identifier: MIT
// Which typed angles mean right angles, and are rotations those of rpy?
#include "moivre/urdf/placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace moivre {
namespace {

Rational decimal(std::int64_t digits, std::int64_t scale) { return {digits, scale}; }

TEST(PlacementTest, RightAnglesAreThoseTypedToAllTheirDigits) {
  EXPECT_EQ(quarter_turns(Rational(0)), 0);
  EXPECT_EQ(quarter_turns(decimal(15708, 10000)), 1);
  EXPECT_EQ(quarter_turns(decimal(157079632679, 100000000000)), 1);
  EXPECT_EQ(quarter_turns(decimal(15707963267948966, 10000000000000000)), 1);
  EXPECT_EQ(quarter_turns(decimal(-314159265359, 100000000000)), -2);
  EXPECT_EQ(quarter_turns(decimal(31415, 10000)), 2) << "cut, not rounded";
}

TEST(PlacementTest, OtherAnglesAreNone) {
  EXPECT_EQ(quarter_turns(decimal(157, 100)), std::nullopt) << "two decimals say little";
  EXPECT_EQ(quarter_turns(decimal(15707963278, 10000000000)), std::nullopt) << "a nanoradian off";
  EXPECT_EQ(quarter_turns(decimal(1, 10)), std::nullopt);
  EXPECT_EQ(quarter_turns(decimal(1, 1000000)), std::nullopt) << "nearly no turn";
}

TEST(PlacementTest, RollIsFirstAndAboutX) {
  const Eigen::Matrix3d turn =
      rotation({Rational(std::numbers::pi / 2), Rational(0), Rational(std::numbers::pi / 2)});
  EXPECT_NEAR((turn * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR((turn * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace moivre
