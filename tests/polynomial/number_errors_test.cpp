// SPDX-License-Identifier: MIT
// Are effects of the same number added with their phases, and those of different numbers as bounds?
#include "moivre/polynomial/number_errors.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

TEST(NumberErrors, OfTheSameNumberMayCancelAndOfDifferentOnesMayNot) {
  NumberErrors sum{{1, 2.0}, {4, Complex(0, 1)}};
  add(sum, Complex(0, -1), {{0, 3.0}, {4, 1.0}});
  ASSERT_EQ(sum.size(), 3);
  EXPECT_EQ(sum[0].number, 0);
  EXPECT_EQ(sum[0].change, Complex(0, -3));
  EXPECT_EQ(sum[1].number, 1);
  EXPECT_EQ(sum[1].change, 2.0);
  EXPECT_EQ(sum[2].number, 4);
  EXPECT_EQ(sum[2].change, 0.0);
  EXPECT_EQ(bound(sum), 5);
}

TEST(NumberErrors, OfWhatIsExactAddNothing) {
  NumberErrors sum;
  add(sum, 7, {});
  EXPECT_TRUE(sum.empty());
  EXPECT_EQ(bound(sum), 0);
}

}  // namespace
}  // namespace moivre
