// SPDX-License-Identifier: MIT
// Do lanes in double-double find what double cannot tell, and the same whatever the number of
// threads?
#include <gtest/gtest.h>

#include "moivre/certify/certifier.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre {
namespace {

SolveResult solve_in_lanes(const System& f, Precision precision, std::uint64_t seed = 1,
                           int threads = 1) {
  SolveOptions options = test::with_seed(seed, threads);
  options.precision = precision;
  return solve(f, *make_lane_tracker(), options);
}

TEST(LanesInDoubleDouble, FindEveryRootOfWilkinsonsPolynomialOfDegreeTwenty) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  const System f = test::system_of(test::problem("wilkinson-20"));
  for (const Precision precision : {Precision::automatic, Precision::double_double}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(seed);
      SolveResult result = solve_in_lanes(f, precision, seed);
      EXPECT_TRUE(result.complete);
      EXPECT_GT(result.paths.double_double, 2U);
      test::expect_conservation(result);
      ASSERT_EQ(result.solutions.size(), 20U);
      std::sort(result.solutions.begin(), result.solutions.end(),
                [](const auto& a, const auto& b) { return a.x[0].real() < b.x[0].real(); });
      double k = 0;
      for (const Solution& s : result.solutions) EXPECT_EQ(s.x[0], ++k);
    }
  }
}

TEST(LanesInDoubleDouble, GiveTheSameRootsThroughout) {
  for (const char* name : {"katsura-5", "noon-3", "multiplicity-4", "chandra-7"}) {
    SCOPED_TRACE(name);
    const System f = test::system_of(test::problem(name));
    const SolveResult result = solve_in_lanes(f, Precision::double_double);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.tracker, "lanes");
    EXPECT_EQ(result.tracker_options.back().value, OptionValue("double-double"));
    EXPECT_EQ(result.paths.double_double, result.paths.tracked);
    test::expect_conservation(result);
    test::expect_counts_of_index(result, test::problem(name));
  }
}

TEST(LanesInDoubleDouble, DoNotDependOnTheNumberOfThreads) {
  struct Case {
    const char* name;
    Precision precision;
  };
  for (const Case& c :
       {Case{"wilkinson-20", Precision::automatic}, Case{"chandra-7", Precision::double_double}}) {
    SCOPED_TRACE(c.name);
    const System f = test::system_of(test::problem(c.name));
    const SolveResult one = solve_in_lanes(f, c.precision, 1, 1);
    const SolveResult three = solve_in_lanes(f, c.precision, 1, 3);
    EXPECT_EQ(one.paths, three.paths);
    ASSERT_EQ(one.solutions.size(), three.solutions.size());
    for (std::size_t k = 0; k < one.solutions.size(); ++k) {
      EXPECT_EQ(one.solutions[k].path, three.solutions[k].path);
      EXPECT_EQ(one.solutions[k].x, three.solutions[k].x);
      EXPECT_EQ(one.solutions[k].accuracy, three.solutions[k].accuracy);
      EXPECT_EQ(one.solutions[k].precision, three.solutions[k].precision);
    }
  }
}

TEST(LanesInDoubleDouble, AreClimbedToByNoPathOfAWellConditionedSystem) {
  for (const char* name : {"katsura-5", "noon-3", "cyclic-5", "multiplicity-4", "chandra-5"}) {
    SCOPED_TRACE(name);
    const System f = test::system_of(test::problem(name));
    EXPECT_EQ(solve_in_lanes(f, Precision::automatic).paths.double_double, 0U);
  }
}

TEST(LanesInDoubleDouble, DecideWhatFailedByPrecisionBeforeAnyPathIsFollowedWithMoreCare) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  for (const char* name : {"wilkinson-20"}) {
    SCOPED_TRACE(name);
    SolveOptions options = test::with_seed(1);
    options.start = StartKind::total_degree;
    const SolveResult result =
        solve(test::system_of(test::problem(name)), *make_lane_tracker(), options);
    test::expect_counts_of_index(result, test::problem(name));
    EXPECT_GT(result.paths.double_double, 0U);
    EXPECT_LE(result.paths.retracked, result.paths.double_double);
  }
}

}  // namespace
}  // namespace moivre
