// SPDX-License-Identifier: MIT
// Are all points found whose numbers are near, and does a point's number move no more than the
// point?
#include "moivre/numeric/near_points.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

std::vector<std::size_t> found(const NearNumbers& numbers, double number, double reach) {
  std::vector<std::size_t> all;
  numbers.visit_near(number, reach, [&](std::size_t k) { all.push_back(k); });
  return all;
}

TEST(NearNumbers, AreThoseWithinReachByTheirSize) {
  const NearNumbers numbers({3, std::nan(""), 1, 2, 1});
  EXPECT_EQ(found(numbers, 1.5, 0.5), (std::vector<std::size_t>{2, 4, 3}));
  EXPECT_EQ(found(numbers, 1.5, 0.4), std::vector<std::size_t>{});
  EXPECT_EQ(found(numbers, std::nan(""), 1), std::vector<std::size_t>{});
  EXPECT_EQ(found(NearNumbers(), 0, 1), std::vector<std::size_t>{});
}

TEST(NumberOfAPoint, MovesNoMoreThanItsCoordinatesTogether) {
  const Point x{1, Complex(0, 2), -3};
  for (std::size_t k = 0; k < x.size(); ++k) {
    Point moved = x;
    moved[k] += Complex(3e-3, 4e-3);
    EXPECT_LE(std::abs(number_of(moved) - number_of(x)), 5e-3 * (1 + 1e-12));
    EXPECT_NE(number_of(moved), number_of(x));
    EXPECT_NEAR(max_distance(moved, x), 5e-3, 1e-15);
  }
}

}  // namespace
}  // namespace moivre
