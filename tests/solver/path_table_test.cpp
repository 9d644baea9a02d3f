// SPDX-License-Identifier: MIT
// Does every path keep exactly one entry, do cycles add up, and is a missing conjugate seen?
#include "path_table.h"

#include <gtest/gtest.h>

#include "group_lists.h"

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

TEST(PathTable, CountsEachPathOnce) {
  PathTable table;
  table.enter_root(0, root_at({1}));
  table.enter_infinity(1);
  table.enter_infinity(2);
  table.enter_failure({3, Failure::precision, 1});
  EXPECT_EQ(table.tracked(), 4U);
  EXPECT_EQ(table.count(PathVerdict::at_infinity), 2U);
}

TEST(PathTable, ALaterEntryTakesThePlaceOfEveryKindOfEntry) {
  for (int earlier = 0; earlier < 4; ++earlier) {
    for (int later = 0; later < 4; ++later) {
      PathTable table;
      for (const int kind : {earlier, later}) {
        if (kind == 0) table.enter_root(7, root_at({1}));
        if (kind == 1) table.enter_infinity(7);
        if (kind == 2) table.enter_failure({7, Failure::precision, 1});
        if (kind == 3) table.leave(7);
      }
      EXPECT_EQ(table.tracked(), 1U) << earlier << later;
      EXPECT_EQ(table.roots().size(), later == 0 ? 1U : 0U) << earlier << later;
      EXPECT_EQ(table.count(PathVerdict::at_infinity), later == 1 ? 1U : 0U) << earlier << later;
      EXPECT_EQ(table.failures().size(), later == 2 ? 1U : 0U) << earlier << later;
      EXPECT_EQ(table.count(PathVerdict::not_needed), later == 3 ? 1U : 0U) << earlier << later;
    }
  }
}

TEST(PathTable, APathThatWasNotFollowedIsOpenAndCountsAsNothing) {
  PathTable table;
  table.enter_infinity(5);
  ASSERT_EQ(table.records().size(), 6U);
  EXPECT_EQ(table.records()[4].verdict, PathVerdict::open);
  EXPECT_EQ(table.tracked(), 1U);
  EXPECT_EQ(table.precision(9), PathPrecision::double_precision);
}

TEST(PathTable, AddsUpTheStepsOfEveryFollowingOfAPath) {
  PathTable table;
  StepCount count;
  count.accepted = 40;
  count.rejected = 2;
  table.count_following(3, count, 0);
  table.enter_failure({3, Failure::precision, 1});
  table.count_following(3, count, 1);
  table.count_following(3, count, 1, true);
  table.enter_infinity(3, true);
  const PathRecord& path = table.records()[3];
  EXPECT_EQ(path.steps, 126U);
  EXPECT_EQ(path.followed, 2);
  EXPECT_EQ(path.stage, 1);
  EXPECT_EQ(path.verdict, PathVerdict::as_rounded);
}

TEST(PathTable, KeepsSixteenBytesOfAPathToInfinity) {
  static_assert(sizeof(PathRecord) == 16);
  PathTable table;
  for (std::uint64_t path = 0; path < 100000; ++path) table.enter_infinity(path);
  EXPECT_EQ(table.count(PathVerdict::at_infinity), 100000U);
  EXPECT_TRUE(table.roots().empty());
  EXPECT_TRUE(table.failures().empty());
}

TEST(PathTable, KeepsEightyBytesOfARootBesideItsPointAndItsProof) {
  static_assert(sizeof(Root) <= 80);
}

TEST(PathTable, GroupsPathsThatEndAtOnePoint) {
  PathTable table;
  table.enter_root(7, root_at({1, 2}, 2));
  table.enter_root(3, root_at({1 + 1e-9, 2}, 2));
  table.enter_root(5, root_at({4, 4}));
  EXPECT_EQ(test::lists_of(table.groups()), (test::GroupLists{{3, 7}, {5}}));
}

TEST(Cycles, OfASimpleEndAreOneTurn) {
  PathTable table;
  table.enter_root(0, root_at({1}));
  EXPECT_EQ(cycles(table, std::vector<std::uint64_t>{0}), std::vector<int>{1});
}

TEST(Cycles, OfFourPathsWithTwoTurnsAreTwo) {
  PathTable table;
  for (const std::uint64_t path : {0U, 1U, 2U, 3U}) table.enter_root(path, root_at({1}, 2));
  EXPECT_EQ(cycles(table, std::vector<std::uint64_t>{0, 1, 2, 3}), (std::vector<int>{2, 2}));
}

TEST(Cycles, OfDifferentWindingNumbersStandSideBySide) {
  PathTable table;
  for (const std::uint64_t path : {0U, 1U, 2U}) table.enter_root(path, root_at({1}, 3));
  for (const std::uint64_t path : {3U, 4U}) table.enter_root(path, root_at({1}, 2));
  EXPECT_EQ(cycles(table, std::vector<std::uint64_t>{0, 1, 2, 3, 4}), (std::vector<int>{2, 3}));
}

TEST(Cycles, DoNotCloseWhenAPathIsMissingOrOneTooMany) {
  PathTable table;
  for (const std::uint64_t path : {0U, 1U, 2U, 3U}) table.enter_root(path, root_at({1}, 3));
  EXPECT_EQ(cycles(table, std::vector<std::uint64_t>{0, 1}), std::nullopt);
  EXPECT_NE(cycles(table, std::vector<std::uint64_t>{0, 1, 2}), std::nullopt);
  EXPECT_EQ(cycles(table, std::vector<std::uint64_t>{0, 1, 2, 3}), std::nullopt);
}

TEST(MissingConjugates, AreNoneOfAClosedSet) {
  PathTable table;
  table.enter_root(0, root_at({Complex(1, 2), 3}));
  table.enter_root(1, root_at({Complex(1, -2), 3}));
  table.enter_root(2, root_at({5, 6}));
  EXPECT_TRUE(missing_conjugates(table).empty());
}

TEST(MissingConjugates, AreTheImagesOfLonelyRoots) {
  PathTable table;
  table.enter_root(0, root_at({Complex(1, 2), Complex(0, -1)}));
  table.enter_root(1, root_at({Complex(3, 2), 0}));
  table.enter_root(2, root_at({Complex(3, -2), 0}));
  EXPECT_EQ(missing_conjugates(table), (std::vector<Point>{{Complex(1, -2), Complex(0, 1)}}));
}

TEST(MissingConjugates, AreNotAskedOfRealOrSingularRoots) {
  PathTable table;
  table.enter_root(0, root_at({Complex(1, 1e-16)}));
  table.enter_root(1, root_at({Complex(0, 1)}, 2));
  EXPECT_TRUE(missing_conjugates(table).empty());
}

}  // namespace
}  // namespace moivre
