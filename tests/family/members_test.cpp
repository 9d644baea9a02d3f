// SPDX-License-Identifier: MIT
// Thousands of members at once: the generic count every time, the roots of direct solves, the same
// on every number of threads.
#include "moivre/family/members.h"

#include <gtest/gtest.h>

#include "families.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

SolveOptions plain(int threads) {
  SolveOptions options;
  options.threads = threads;
  options.certify = false;
  return options;
}

std::vector<Point> points_of(const MemberRoots& member) {
  std::vector<Point> points;
  for (const MemberRoot& root : member.roots) points.push_back(root.x);
  return points;
}

TEST(SolveMembers, HasTheGenericCountEveryTime) {
  const auto lanes = make_lane_tracker();
  const Family family = learn(conics(), *lanes);
  const auto results = solve_members(family, random_members(3, 3000), *lanes, plain(2));
  std::size_t judged = 0;
  for (const MemberRoots& member : results) {
    EXPECT_TRUE(member.complete);
    EXPECT_EQ(member.roots.size(), 4U);
    EXPECT_EQ(member.completeness, std::nullopt) << "no certificates were asked for";
    judged += member.judged ? 1 : 0;
  }
  EXPECT_LE(judged, 3U);
}

TEST(SolveMembers, FindsTheRootsOfDirectSolves) {
  const auto lanes = make_lane_tracker();
  const Family family = learn(conics(), *lanes);
  const std::vector<Point> members = random_members(3, 500);
  const auto results = solve_members(family, members, *lanes, plain(1));
  for (std::size_t k = 0; k < members.size(); ++k) {
    const SolveResult direct =
        solve(member_system(family, exact_values(members[k])), *lanes, plain(1));
    std::vector<Point> points;
    std::uint64_t real = 0;
    for (const Solution& root : direct.solutions) {
      points.push_back(root.x);
      real += root.real ? 1 : 0;
    }
    EXPECT_TRUE(are_same(points_of(results[k]), points, 1e-8)) << k;
    EXPECT_EQ(results[k].real_count(), real) << k;
  }
}

TEST(SolveMembers, DoesNotDependOnTheNumberOfThreadsAndAgreesWithTheOtherTracker) {
  const auto lanes = make_lane_tracker();
  const Family family = learn(four_bar(), *lanes);
  const std::vector<Point> members = random_members(6, 100);
  const auto one = solve_members(family, members, *lanes, plain(1));
  const auto three = solve_members(family, members, *lanes, plain(3));
  const auto cvode = solve_members(family, members, *make_cvode_tracker(), plain(1));
  for (std::size_t k = 0; k < members.size(); ++k) {
    EXPECT_EQ(points_of(one[k]), points_of(three[k]));
    EXPECT_TRUE(are_same(points_of(one[k]), points_of(cvode[k]), 1e-8)) << k;
  }
}

TEST(SolveMembers, HandsSpecialMembersToTheJudge) {
  const auto lanes = make_lane_tracker();
  const Family family = learn(conics(), *lanes);
  std::vector<Point> members = random_members(3, 40);
  members[3] = {0, 0, 0};
  members[17] = {1, 0, 2};
  const auto results = solve_members(family, members, *lanes, plain(1));
  EXPECT_TRUE(results[3].judged);
  EXPECT_TRUE(results[3].complete);
  ASSERT_EQ(results[3].roots.size(), 2U);
  EXPECT_EQ(results[3].roots.front().multiplicity, 2U);
  EXPECT_TRUE(results[17].judged);
  EXPECT_EQ(results[17].at_infinity, 2U);
  EXPECT_EQ(results[17].roots.size(), 2U);
  EXPECT_EQ(results[4].roots.size(), 4U);
}

TEST(SolveMembers, AreProvedWhereThatIsAskedFor) {
  const auto lanes = make_lane_tracker();
  const Family family = learn(conics(), *lanes);
  SolveOptions options = plain(2);
  options.certify = true;
  for (const MemberRoots& member : solve_members(family, random_members(3, 50), *lanes, options)) {
    EXPECT_EQ(member.completeness, RootCompleteness::proved);
    for (const MemberRoot& root : member.roots) EXPECT_EQ(root.certified, true);
  }
}

TEST(SolveMembers, OfAFamilyThatMayLackRootsAreNotComplete) {
  const auto lanes = make_lane_tracker();
  Family family = learn(conics(), *lanes);
  family.roots.pop_back();
  family.learning.complete = false;
  family.learning.bound.reset();
  for (const bool certify : {true, false}) {
    SolveOptions options = plain(1);
    options.certify = certify;
    for (const MemberRoots& member : solve_members(family, random_members(3, 5), *lanes, options)) {
      EXPECT_EQ(member.roots.size(), 3U);
      EXPECT_FALSE(member.complete);
    }
  }
}

TEST(SolveMembers, OfComplexParametersHaveTheirRealRoots) {
  const auto lanes = make_lane_tracker();
  const Family family =
      learn(unlearned_family(read_system({"test", "1 3\nb*x^2 - a*b;\n"}), {{"a"}, {"b"}}), *lanes);
  const std::vector<Point> members{{4, Complex(0, 1)}, {-4, Complex(0, 1)}};
  for (const bool certify : {true, false}) {
    SolveOptions options = plain(1);
    options.certify = certify;
    const auto results = solve_members(family, members, *lanes, options);
    EXPECT_EQ(results[0].real_count(), 2U);
    EXPECT_EQ(results[1].real_count(), 0U);
  }
}

TEST(SolveMembers, StopsWhenItIsTold) {
  const auto lanes = make_lane_tracker();
  const Family family = learn(conics(), *lanes);
  const std::atomic<bool> stop{true};
  for (const MemberRoots& member :
       solve_members(family, random_members(3, 50), *lanes, plain(1), stop)) {
    EXPECT_FALSE(member.complete);
    EXPECT_EQ(member.completeness, std::nullopt);
  }
}

TEST(SolveMembers, ThatAreStoppedHaveNoRootWithoutCoordinates) {
  const auto lanes = make_lane_tracker();
  const Family family = learn(conics(), *lanes);
  std::atomic<bool> stop{false};
  SolveOptions options = plain(1);
  options.progress = [&stop](const Progress& progress) { stop = progress.done >= 20; };
  const auto results = solve_members(family, random_members(3, 200), *lanes, options, stop);
  for (const MemberRoots& member : results) {
    EXPECT_TRUE(member.complete || member.at_infinity == 0U);
    for (const MemberRoot& root : member.roots) EXPECT_EQ(root.x.size(), family.unknowns());
  }
  EXPECT_FALSE(results.back().complete);
}

TEST(SolveMembers, RefusesMembersOfAnotherSize) {
  const auto lanes = make_lane_tracker();
  EXPECT_THROW(solve_members(learn(conics(), *lanes), random_members(2, 3), *lanes, plain(1)),
               std::invalid_argument);
}

}  // namespace
}  // namespace moivre
