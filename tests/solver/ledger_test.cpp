// SPDX-License-Identifier: MIT
// Does every path keep exactly one entry, do cycles add up, and is a missing conjugate seen?
#include "ledger.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

Root root_at(const Point& x, std::optional<int> winding = std::nullopt) {
  Root root;
  root.point.x = x;
  root.point.simple = !winding;
  root.point.accuracy = 1e-15;
  root.winding = winding;
  root.tolerance = winding ? 1e-7 : 1e-13;
  return root;
}

TEST(Ledger, CountsEachPathOnce) {
  Ledger ledger;
  ledger.enter_root(0, root_at({1}));
  ledger.enter_infinity(1);
  ledger.enter_infinity(2);
  ledger.enter_failure({3, Failure::precision, 1});
  EXPECT_EQ(ledger.tracked(), 4U);
  EXPECT_EQ(ledger.count(PathVerdict::at_infinity), 2U);
}

TEST(Ledger, ALaterEntryTakesThePlaceOfEveryKindOfEntry) {
  for (int earlier = 0; earlier < 4; ++earlier) {
    for (int later = 0; later < 4; ++later) {
      Ledger ledger;
      for (const int kind : {earlier, later}) {
        if (kind == 0) ledger.enter_root(7, root_at({1}));
        if (kind == 1) ledger.enter_infinity(7);
        if (kind == 2) ledger.enter_failure({7, Failure::precision, 1});
        if (kind == 3) ledger.leave(7);
      }
      EXPECT_EQ(ledger.tracked(), 1U) << earlier << later;
      EXPECT_EQ(ledger.roots().size(), later == 0 ? 1U : 0U) << earlier << later;
      EXPECT_EQ(ledger.count(PathVerdict::at_infinity), later == 1 ? 1U : 0U) << earlier << later;
      EXPECT_EQ(ledger.failures().size(), later == 2 ? 1U : 0U) << earlier << later;
      EXPECT_EQ(ledger.count(PathVerdict::not_needed), later == 3 ? 1U : 0U) << earlier << later;
    }
  }
}

TEST(Ledger, APathThatWasNotFollowedIsOpenAndCountsAsNothing) {
  Ledger ledger;
  ledger.enter_infinity(5);
  ASSERT_EQ(ledger.records().size(), 6U);
  EXPECT_EQ(ledger.records()[4].verdict, PathVerdict::open);
  EXPECT_EQ(ledger.tracked(), 1U);
  EXPECT_EQ(ledger.precision(9), PathPrecision::double_precision);
}

TEST(Ledger, AddsUpTheStepsOfEveryFollowingOfAPath) {
  Ledger ledger;
  StepCount count;
  count.accepted = 40;
  count.rejected = 2;
  ledger.count_following(3, count, 0);
  ledger.enter_failure({3, Failure::precision, 1});
  ledger.count_following(3, count, 1);
  ledger.count_following(3, count, 1, true);
  ledger.enter_infinity(3, true);
  const PathRecord& path = ledger.records()[3];
  EXPECT_EQ(path.steps, 126U);
  EXPECT_EQ(path.followed, 2);
  EXPECT_EQ(path.stage, 1);
  EXPECT_EQ(path.verdict, PathVerdict::as_rounded);
}

TEST(Ledger, KeepsSixteenBytesOfAPathToInfinity) {
  static_assert(sizeof(PathRecord) == 16);
  Ledger ledger;
  for (std::uint64_t path = 0; path < 100000; ++path) ledger.enter_infinity(path);
  EXPECT_EQ(ledger.count(PathVerdict::at_infinity), 100000U);
  EXPECT_TRUE(ledger.roots().empty());
  EXPECT_TRUE(ledger.failures().empty());
}

TEST(Ledger, GroupsPathsThatEndAtOnePoint) {
  Ledger ledger;
  ledger.enter_root(7, root_at({1, 2}, 2));
  ledger.enter_root(3, root_at({1 + 1e-9, 2}, 2));
  ledger.enter_root(5, root_at({4, 4}));
  EXPECT_EQ(ledger.groups(), (std::vector<std::vector<std::uint64_t>>{{3, 7}, {5}}));
}

TEST(Cycles, OfASimpleEndAreOneTurn) {
  Ledger ledger;
  ledger.enter_root(0, root_at({1}));
  EXPECT_EQ(cycles(ledger, {0}), std::vector<int>{1});
}

TEST(Cycles, OfFourPathsWithTwoTurnsAreTwo) {
  Ledger ledger;
  for (const std::uint64_t path : {0U, 1U, 2U, 3U}) ledger.enter_root(path, root_at({1}, 2));
  EXPECT_EQ(cycles(ledger, {0, 1, 2, 3}), (std::vector<int>{2, 2}));
}

TEST(Cycles, OfDifferentWindingNumbersStandSideBySide) {
  Ledger ledger;
  for (const std::uint64_t path : {0U, 1U, 2U}) ledger.enter_root(path, root_at({1}, 3));
  for (const std::uint64_t path : {3U, 4U}) ledger.enter_root(path, root_at({1}, 2));
  EXPECT_EQ(cycles(ledger, {0, 1, 2, 3, 4}), (std::vector<int>{2, 3}));
}

TEST(Cycles, DoNotCloseWhenAPathIsMissingOrOneTooMany) {
  Ledger ledger;
  for (const std::uint64_t path : {0U, 1U, 2U, 3U}) ledger.enter_root(path, root_at({1}, 3));
  EXPECT_EQ(cycles(ledger, {0, 1}), std::nullopt);
  EXPECT_NE(cycles(ledger, {0, 1, 2}), std::nullopt);
  EXPECT_EQ(cycles(ledger, {0, 1, 2, 3}), std::nullopt);
}

TEST(MissingConjugates, AreNoneOfAClosedSet) {
  Ledger ledger;
  ledger.enter_root(0, root_at({Complex(1, 2), 3}));
  ledger.enter_root(1, root_at({Complex(1, -2), 3}));
  ledger.enter_root(2, root_at({5, 6}));
  EXPECT_TRUE(missing_conjugates(ledger).empty());
}

TEST(MissingConjugates, AreTheImagesOfLonelyRoots) {
  Ledger ledger;
  ledger.enter_root(0, root_at({Complex(1, 2), Complex(0, -1)}));
  ledger.enter_root(1, root_at({Complex(3, 2), 0}));
  ledger.enter_root(2, root_at({Complex(3, -2), 0}));
  EXPECT_EQ(missing_conjugates(ledger), (std::vector<Point>{{Complex(1, -2), Complex(0, 1)}}));
}

TEST(MissingConjugates, AreNotAskedOfRealOrSingularRoots) {
  Ledger ledger;
  ledger.enter_root(0, root_at({Complex(1, 1e-16)}));
  ledger.enter_root(1, root_at({Complex(0, 1)}, 2));
  EXPECT_TRUE(missing_conjugates(ledger).empty());
}

}  // namespace
}  // namespace moivre
