// SPDX-License-Identifier: MIT
// Is what is kept of a ball's sizes on the safe side, wherever they lie?
#include "moivre/certify/ball_sizes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace moivre::test {
namespace {

TEST(BallSizesTest, RadiiAreRoundedDownAndErrorsUpByLessThanAThirtySecondth) {
  std::mt19937_64 numbers(1);
  std::uniform_real_distribution<double> fraction(1, 2);
  for (int exponent = -1022; exponent <= 1023; ++exponent) {
    const double x = std::ldexp(fraction(numbers), exponent);
    const BallSizes sizes(std::span(&x, 1), std::span(&x, 1));
    EXPECT_LE(sizes.radius(0), x);
    EXPECT_GT(sizes.radius(0), x * (1 - 1.0 / 32));
    EXPECT_GE(sizes.error(0), x);
    EXPECT_LE(sizes.error(0) / 2, x / 2 * (1 + 1.0 / 32));
  }
}

TEST(BallSizesTest, NumbersOfFewBitsAreKeptAsTheyAre) {
  for (const double x :
       {0.0, 1.0, 1.5, 0x1p-900, 63 * 0x1p-1027, std::numeric_limits<double>::infinity()}) {
    const BallSizes sizes(std::span(&x, 1), std::span(&x, 1));
    EXPECT_EQ(sizes.radius(0), x);
    EXPECT_EQ(sizes.error(0), x);
  }
}

TEST(BallSizesTest, AnErrorThatRoundingBringsToItsRadiusIsToldApartNoLonger) {
  const double radius = 1.01;
  const double error = 1.001;
  EXPECT_FALSE(BallSizes(std::span(&radius, 1), std::span(&error, 1)).are_apart());
  const double less = 0.96;
  EXPECT_TRUE(BallSizes(std::span(&radius, 1), std::span(&less, 1)).are_apart());
}

}  // namespace
}  // namespace moivre::test
