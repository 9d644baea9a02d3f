// SPDX-License-Identifier: MIT
// Do contours go where they say, with dt/ds as the limit of differences and all digits of 1 - t?
#include "moivre/tracker/contour.h"

#include <gtest/gtest.h>

#include <numbers>

namespace moivre {
namespace {

const Complex kTurn(0, 2 * std::numbers::pi);

TEST(Contour, ASegmentRunsStraightAndEndsExactly) {
  const Contour segment = Contour::segment({0.1, 0.2}, 1.0);
  EXPECT_EQ(segment.at(0).t, Complex(0.1, 0.2));
  EXPECT_EQ(segment.at(1).t, 1.0);
  EXPECT_EQ(segment.at(1).rest, 0.0);
  EXPECT_LT(std::abs(segment.at(0.5).t - Complex(0.55, 0.1)), 1e-15);
}

TEST(Contour, ASpiralTurnsRoundOneOrHalvesTheWayThere) {
  const Contour turn = Contour::spiral(0.01, kTurn);
  EXPECT_LT(std::abs(turn.at(1).rest - 0.01), 1e-16);
  EXPECT_LT(std::abs(turn.at(0.5).rest + 0.01), 1e-16);
  EXPECT_LT(std::abs(Contour::spiral(0.01, -std::log(2.0)).at(1).rest - 0.005), 1e-17);
}

TEST(Contour, ALandingKeepsTheDigitsOfOneMinusT) {
  const Contour landing = Contour::landing(1e-20);
  EXPECT_EQ(landing.at(0).rest, 1e-20);
  EXPECT_EQ(landing.at(0.5).rest, 0.5e-20);
  EXPECT_EQ(landing.at(1).rest, 0.0);
}

TEST(Contour, TheRateIsTheLimitOfDifferencesAndTPlusItsRestIsOne) {
  const double h = 1e-5;
  for (const Contour& contour :
       {Contour::segment({0, 0.5}, {0.8, -1}), Contour::landing({0.3, 0.1}),
        Contour::spiral({0.2, 0.1}, kTurn), Contour::spiral(0.3, {-1, 2})}) {
    for (const double s : {0.25, 0.5, 0.75}) {
      EXPECT_LT(std::abs(contour.at(s).t + contour.at(s).rest - 1.0), 1e-15);
      const Complex quotient = (contour.at(s + h).t - contour.at(s - h).t) / (2 * h);
      // h^2 / 6 times |lambda|^3 |rest| <= 60, and rounding over h.
      EXPECT_LT(std::abs(quotient - contour.dt(s)), 10 * h * h + 1e-10);
    }
  }
}

}  // namespace
}  // namespace moivre
