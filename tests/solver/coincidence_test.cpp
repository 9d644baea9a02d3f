// SPDX-License-Identifier: MIT
// Are points grouped exactly when they are nearer to each other than they are known?
#include "coincidence.h"

#include <gtest/gtest.h>

#include "group_lists.h"
#include "moivre/numeric/random.h"

namespace moivre {
namespace {

using Groups = test::GroupLists;

constexpr double kTolerance = 1e-8;

Groups groups_of(const std::vector<Point>& points, double tolerance = kTolerance) {
  std::vector<KnownPoint> known;
  for (const Point& x : points) known.push_back({&x, tolerance});
  return test::lists_of(coincidence_groups(known));
}

TEST(CoincidenceGroups, OfNoPointsAreNone) { EXPECT_EQ(groups_of({}), Groups{}); }

TEST(CoincidenceGroups, LeaveApartWhatIsFurtherThanBothTolerances) {
  EXPECT_EQ(groups_of({{1, 0}, {1 + 3 * kTolerance, 0}}), (Groups{{0}, {1}}));
}

TEST(CoincidenceGroups, JoinWhatIsNearerThanBothTolerances) {
  EXPECT_EQ(groups_of({{1, 0}, {1 + kTolerance, 0}}), (Groups{{0, 1}}));
}

TEST(CoincidenceGroups, AreRelativeToTheSizeOfLargePoints) {
  constexpr double kLarge = 1e6;
  EXPECT_EQ(groups_of({{kLarge, 0}, {kLarge * (1 + kTolerance), 0}}), (Groups{{0, 1}}));
  EXPECT_EQ(groups_of({{kLarge, 0}, {kLarge * (1 + 3 * kTolerance), 0}}), (Groups{{0}, {1}}));
}

TEST(CoincidenceGroups, AreConnectedComponents) {
  const double step = 1.5 * kTolerance;
  EXPECT_EQ(groups_of({{1}, {1 + 2 * step}, {1 + step}, {2}}), (Groups{{0, 1, 2}, {3}}));
}

TEST(CoincidenceGroups, TellConjugatesAndSignsApart) {
  EXPECT_EQ(groups_of({{Complex(0, 1)}, {Complex(0, -1)}, {1}, {-1}}),
            (Groups{{0}, {1}, {2}, {3}}));
}

TEST(CoincidenceGroups, ReachFromALooselyKnownPointToAWellKnownOne) {
  const Point loose{1};
  const Point sharp{1 + 1e-4};
  EXPECT_EQ(test::lists_of(coincidence_groups({{&loose, 1e-3}, {&sharp, 1e-14}})),
            (Groups{{0, 1}}));
  EXPECT_EQ(test::lists_of(coincidence_groups({{&loose, 1e-6}, {&sharp, 1e-14}})),
            (Groups{{0}, {1}}));
}

TEST(CoincidenceGroups, FindEveryPairAmongManyPoints) {
  constexpr std::size_t kPairs = 500;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    std::vector<Point> points;
    for (std::uint64_t k = 0; k < 2 * kPairs; ++k) {
      const std::uint64_t which = k % kPairs;
      Point x;
      for (std::uint64_t i = 0; i < 3; ++i) {
        x.push_back(random_phase(seed, RandomStream::slice, 1000 + 3 * which + i));
      }
      if (k >= kPairs) x[k % 3] += kTolerance;
      points.push_back(std::move(x));
    }
    const Groups groups = groups_of(points);
    ASSERT_EQ(groups.size(), kPairs);
    for (std::size_t k = 0; k < kPairs; ++k) {
      EXPECT_EQ(groups[k], (std::vector<std::uint64_t>{k, k + kPairs}));
    }
  }
}

}  // namespace
}  // namespace moivre
