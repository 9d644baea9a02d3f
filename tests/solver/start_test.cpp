// SPDX-License-Identifier: MIT
// Does every start lead to the same roots, and does the automatic choice take the one with few
// paths?
#include <gtest/gtest.h>

#include "moivre/solver/trace.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre::test {
namespace {

SolveOptions with_start(StartKind start, std::uint64_t seed) {
  SolveOptions options = with_seed(seed);
  options.start = start;
  return options;
}

constexpr StartKind kStarts[] = {StartKind::automatic, StartKind::total_degree,
                                 StartKind::multihomogeneous, StartKind::polyhedral};

TEST(Start, EveryOneLeadsToTheRootsOfTheIndexWithBothTrackers) {
  for (const char* name : {"katsura-5", "noon-3", "cyclic-5", "eco-5", "reimer-3", "puma"}) {
    for (const StartKind start : kStarts) {
      for (const std::uint64_t seed : {11UL, 12UL}) {
        const System f = system_of(problem(name));
        for (const bool lanes : {false, true}) {
          const auto tracker = lanes ? make_lane_tracker() : make_cvode_tracker();
          const SolveResult result = solve(f, *tracker, with_start(start, seed));
          expect_conservation(result);
          expect_counts_of_index(result, problem(name));
          if (HasFailure()) FAIL() << name << ' ' << to_string(start) << ' ' << seed;
        }
      }
    }
  }
}

TEST(Start, AutomaticTakesTheMixedVolumeWhereTheDegreesPromiseMore) {
  const SolveResult eco =
      solve_with_cvode(system_of(problem("eco-6")), with_start(StartKind::automatic, 3));
  EXPECT_EQ(eco.start.source, StartSource::polyhedral);
  EXPECT_EQ(eco.start.paths, 16U);
  EXPECT_EQ(eco.start.counts.mixed_volume.paths, std::optional<std::uint64_t>(16));
  const SolveResult katsura =
      solve_with_cvode(system_of(problem("katsura-5")), with_start(StartKind::automatic, 3));
  EXPECT_EQ(katsura.start.source, StartSource::total_degree);
  EXPECT_EQ(katsura.start.counts.mixed_volume.paths, katsura.start.counts.total_degree.paths);
}

// The root at (1190, -0.0138) goes the way of 23 paths to one point at infinity until 1 - t is
// 1e-30.
TEST(Start, FindsALargeRootThatGrowthAloneCallsInfinite) {
  const System f = read("2\n-2*x^2*y^3+7*x*y^2+y-9;\nx^2*y^3+8*x*y^2+7*y+2;\n");
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const SolveResult result = solve_with_cvode(f, with_seed(seed));
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.solutions.size(), 2U) << seed;
    SolveOptions total_degree = with_start(StartKind::total_degree, seed);
    const SolveResult other = solve_with_cvode(f, total_degree);
    EXPECT_TRUE(!other.complete || other.solutions.size() == 2U) << seed;
  }
}

TEST(Start, FindsRootsWithZeroCoordinates) {
  // x y = 0 twice over: (0, 0), (0, 2), (3, 0).
  const System f = read("2\nx^2*y + x^2 - 3*x + x*y;\nx*y^2 + y^2 - 2*y + x*y;\n");
  for (const StartKind start : kStarts) {
    const SolveResult result = solve_with_cvode(f, with_start(start, 5));
    EXPECT_TRUE(result.complete);
    const auto zeros =
        std::count_if(result.solutions.begin(), result.solutions.end(),
                      [](const Solution& s) { return s.x[0] == 0.0 || s.x[1] == 0.0; });
    EXPECT_EQ(zeros, 3) << to_string(start);
  }
}

TEST(Start, OfOneGroupIsThatOfTheTotalDegree) {
  const System f = system_of(problem("cyclic-5"));
  const SolveResult result = solve_with_cvode(f, with_start(StartKind::multihomogeneous, 3));
  EXPECT_EQ(result.start.source, StartSource::total_degree);
  EXPECT_EQ(result.start.counts.multihomogeneous.paths, result.start.counts.total_degree.paths);
  EXPECT_EQ(result.solutions.size(), 70U);
}

TEST(Start, ResultsDoNotDependOnTheNumberOfThreads) {
  for (const StartKind start : kStarts) {
    SolveOptions one = with_start(start, 7);
    SolveOptions four = one;
    four.threads = 4;
    const System f = system_of(problem("cyclic-6"));
    const SolveResult a = solve(f, *make_lane_tracker(), one);
    const SolveResult b = solve(f, *make_lane_tracker(), four);
    ASSERT_EQ(a.solutions.size(), b.solutions.size());
    for (std::size_t k = 0; k < a.solutions.size(); ++k) {
      EXPECT_EQ(a.solutions[k].path, b.solutions[k].path);
      EXPECT_EQ(a.solutions[k].x, b.solutions[k].x);
    }
  }
}

TEST(Start, ATraceEndsWhereSolveEnds) {
  const System f = system_of(problem("cyclic-5"));
  for (const StartKind start : kStarts) {
    const SolveOptions options = with_start(start, 4);
    const auto tracker = make_cvode_tracker();
    const SolveResult result = solve(f, *tracker, options);
    for (std::size_t k = 0; k < result.solutions.size(); k += 17) {
      const Solution& root = result.solutions[k];
      const Trace trace = trace_path(f, *tracker, options, root.path, std::atomic<bool>{false});
      // A path that solve followed again is traced as it went at first.
      if (trace.end.status == PathStatus::failed && result.paths.retracked > 0) continue;
      EXPECT_EQ(trace.end.status, PathStatus::finite);
      EXPECT_LT(distance(trace.x, root.x), 1e-6) << to_string(start) << ' ' << root.path;
    }
  }
}

}  // namespace
}  // namespace moivre::test
