// SPDX-License-Identifier: MIT
// Is real, not real or unknown told of a ball as it should be, above all where |Im| lies just under
// and over a radius?
#include "reality.h"

#include <gtest/gtest.h>

namespace moivre::test {
namespace {

/// Of radius 1 and error 1/2 around i im.
Reality reality_at(double im, double finer_im = 0) {
  Certificate c;
  c.verdict = Verdict::certified;
  c.midpoint = {Complex(3, im)};
  if (finer_im != 0) c.finer = {{Complex(0, finer_im)}};
  c.sizes = BallSizes(std::vector{1.0}, std::vector{0.5});
  return reality_of(c, true);
}

TEST(Reality, OfABallFollowsFromErrorAndRadius) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(reality_at(0), Reality::real);
    // The conjugate of the enclosure reaches to 2 |Im m| + error from m.
    EXPECT_EQ(reality_at(sign * 0.2499), Reality::real);
    EXPECT_EQ(reality_at(sign * 0.2501), Reality::unknown);
    // Just under the error and the radius: the ball and its conjugate overlap, which proves
    // nothing.
    EXPECT_EQ(reality_at(sign * 0.4999), Reality::unknown);
    EXPECT_EQ(reality_at(sign * 0.5001), Reality::not_real);
    EXPECT_EQ(reality_at(sign * 0.9999), Reality::not_real);
  }
}

TEST(Reality, CountsWhatTheMidpointHasBeyondDouble) {
  EXPECT_EQ(reality_at(0.5, 0x1p-60), Reality::unknown);
  EXPECT_EQ(reality_at(0.5 + 0x1p-50, -0x1p-55), Reality::not_real);
  EXPECT_EQ(reality_at(0.25 - 0x1p-60, 0x1p-57), Reality::unknown);
}

TEST(Reality, OneCoordinateShowsThatARootIsNotRealAllThatItIs) {
  Certificate c;
  c.verdict = Verdict::certified;
  c.midpoint = {Complex(1, 0), Complex(2, 0.3), Complex(1, 1e-3)};
  c.sizes = BallSizes(std::vector{1.0, 1.0, 1e-2}, std::vector{0.1, 0.1, 1e-4});
  EXPECT_EQ(reality_of(c, true), Reality::not_real);
  c.midpoint[1] = 2;
  EXPECT_EQ(reality_of(c, true), Reality::not_real);
  c.midpoint[2] = Complex(1, 1e-5);
  EXPECT_EQ(reality_of(c, true), Reality::real);
  EXPECT_EQ(reality_of(c, false), Reality::unknown);
  c.sizes.set(0, 0.1, 0.1);
  EXPECT_EQ(reality_of(c, true), Reality::unknown);
}

}  // namespace
}  // namespace moivre::test
