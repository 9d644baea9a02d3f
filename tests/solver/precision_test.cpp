// SPDX-License-Identifier: MIT
// Is a path followed in the precision that it needs, no other path with it, and does the result say
// so?
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "moivre/tracker/double_double_tracker.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "path_pool.h"
#include "prepare.h"
#include "problem_set.h"
#include "setting.h"

namespace moivre {
namespace {

using test::problem;
using test::system_of;
using test::with_seed;

SolveResult solve_with(const System& f, Precision precision, std::uint64_t seed = 1) {
  SolveOptions options = with_seed(seed);
  options.precision = precision;
  return test::solve_with_cvode(f, options);
}

TEST(Precision, FindsEveryRootOfWilkinsonsPolynomialOfDegreeTwenty) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const SolveResult result =
        solve_with(system_of(problem("wilkinson-20")), Precision::automatic, seed);
    EXPECT_TRUE(result.complete);
    std::set<Complex, bool (*)(Complex, Complex)> roots(
        [](Complex a, Complex b) { return a.real() < b.real(); });
    for (const Solution& s : result.solutions) roots.insert(s.x[0]);
    ASSERT_EQ(roots.size(), 20U);
    double k = 0;
    for (const Complex root : roots) EXPECT_EQ(root, ++k);
    EXPECT_GT(result.paths.double_double, 0U);
    test::expect_conservation(result);
  }
}

TEST(Precision, TellsTheRungOfEveryRoot) {
  const SolveResult result = solve_with(system_of(problem("wilkinson-20")), Precision::automatic);
  std::map<PathPrecision, std::uint64_t> roots;
  for (const Solution& s : result.solutions) ++roots[s.precision];
  EXPECT_EQ(roots[PathPrecision::mixed], result.paths.mixed);
  EXPECT_EQ(roots[PathPrecision::double_double], result.paths.double_double);
}

/// Verdicts on these paths of kin1 with seed 1, followed by `tracker`.
std::vector<PathStatus> ends_of_kin1(const std::vector<std::uint64_t>& paths,
                                     const Tracker& tracker, bool goes_straight) {
  SolveOptions options = with_seed(1);
  options.start = StartKind::total_degree;
  const std::atomic<bool> go_on{false};
  const Prepared prepared = prepare(system_of(problem("kin1")), options, go_on);
  options.endgame.goes_straight = goes_straight;
  const PathProblem path_problem{*prepared.plan, tracker, options.endgame};
  std::vector<PathStatus> ends;
  track_paths(
      path_problem, {paths.size(), [&](std::uint64_t k) { return paths[k]; }}, 0, 1,
      [&](std::uint64_t, PathEnd&& end) { ends.push_back(end.status); }, std::atomic<bool>{false});
  return ends;
}

// They grow like r^(-7/4) with r = 1 - t. Where that can be seen, from r = 1e-5 on, J's condition
// has passed 1e16.
TEST(Precision, TellsInfinityWhereTheJacobianInDoubleSaysNothing) {
  const std::vector<std::uint64_t> paths{14, 43, 99};
  const std::vector<PathStatus> in_double = ends_of_kin1(paths, *make_cvode_tracker(), false);
  const std::vector<PathStatus> beyond = ends_of_kin1(paths, *make_double_double_tracker(), true);
  EXPECT_EQ(beyond, std::vector<PathStatus>(3, PathStatus::at_infinity));
  EXPECT_EQ(std::count(in_double.begin(), in_double.end(), PathStatus::finite), 0);
}

TEST(Precision, StaysDoubleWhereThatIsAskedForAndSaysWhatItLacks) {
  const SolveResult result =
      solve_with(system_of(problem("wilkinson-20")), Precision::double_precision);
  EXPECT_FALSE(result.complete);
  EXPECT_GT(result.paths.failed, 0U);
  EXPECT_EQ(result.paths.double_double, 0U);
}

TEST(Precision, NoPathNeedsDoubleDoubleInWellConditionedSystems) {
  for (const char* name : {"katsura-5", "noon-3", "cyclic-5", "multiplicity-4", "chandra-5"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(solve_with(system_of(problem(name)), Precision::automatic).paths.double_double, 0U);
  }
}

TEST(Precision, DoubleDoubleThroughoutGivesTheSameRoots) {
  for (const char* name : {"katsura-5", "noon-3", "multiplicity-4"}) {
    SCOPED_TRACE(name);
    const System f = system_of(problem(name));
    const SolveResult result = solve_with(f, Precision::double_double);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.tracker, "double-double");
    EXPECT_EQ(result.paths.double_double, result.paths.tracked);
    EXPECT_EQ(result.solutions.size(), solve_with(f, Precision::automatic).solutions.size());
    EXPECT_EQ(test::sum_of_multiplicities(result), problem(name).roots.with_multiplicity);
  }
}

// With a tracker to fall back upon, which has double's digits.
TEST(Precision, DoubleDoubleThroughoutIsNotGivenUpForAFallback) {
  const auto tracker = make_cvode_tracker();
  const auto fallback = make_cvode_tracker();
  const std::atomic<bool> stop{false};
  const System f = test::read("2\n x^2 + y^2 - 5;\n x*y - 2;\n");
  SolveOptions options = test::with_seed(1);
  options.fallback = fallback.get();
  EXPECT_TRUE(Setting(f, *tracker, options, stop).falls_back(2));
  options.precision = Precision::double_double;
  EXPECT_FALSE(Setting(f, *tracker, options, stop).falls_back(2));
}

TEST(Precision, RootsAMillionthApartAreNotOneSingularRoot) {
  // (x - 1)(x - 1 - 10^-6)(x - 1 - 2 10^-6)(x - 1 - 3 10^-6)(x - 5): in double a fourfold root.
  const System f = test::read("1\n(x - 1)*(x - 1.000001)*(x - 1.000002)*(x - 1.000003)*(x - 5);\n");
  const std::vector<double> wanted{1, 1.000001, 1.000002, 1.000003, 5};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    SolveResult result = solve_with(f, Precision::automatic, seed);
    test::expect_conservation(result);
    EXPECT_TRUE(result.complete);
    ASSERT_EQ(result.solutions.size(), wanted.size());
    std::sort(result.solutions.begin(), result.solutions.end(),
              [](const auto& a, const auto& b) { return a.x[0].real() < b.x[0].real(); });
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const Solution& s = result.solutions[k];
      EXPECT_EQ(s.multiplicity, 1U);
      EXPECT_LE(std::abs(s.x[0] - wanted[k]), s.accuracy * wanted[k]);
      EXPECT_LT(s.accuracy, 1e-9);
    }
  }
}

TEST(Precision, TenRootsWithinAMillionthAreFoundByPathsOfMoreDigits) {
  const System f = test::read("1\n (x - 1)^10 - 1e-60;\n");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    // Else exact algebra has them before the paths.
    SolveOptions options = with_seed(seed);
    options.every_path = true;
    const SolveResult result = test::solve_with_cvode(f, options);
    test::expect_conservation(result);
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
    EXPECT_EQ(result.paths.multiprecision, 10U);
    ASSERT_EQ(result.solutions.size(), 10U);
    for (const Solution& s : result.solutions) {
      EXPECT_EQ(s.precision, PathPrecision::multiprecision);
      EXPECT_NEAR(std::abs(s.x[0] - 1.0), 1e-6, 1e-15);
      EXPECT_LT(s.accuracy, 1e-15);
    }
  }
}

TEST(Precision, ASingularRootStaysOneInDoubleDouble) {
  for (const char* name :
       {"multiplicity-2", "multiplicity-7", "double-lines-4", "griewank-osborne"}) {
    SCOPED_TRACE(name);
    const SolveResult result = solve_with(system_of(problem(name)), Precision::automatic);
    EXPECT_EQ(result.paths.double_double, 0U);
    EXPECT_EQ(test::sum_of_multiplicities(result), problem(name).roots.with_multiplicity);
    EXPECT_EQ(result.solutions.size(), problem(name).roots.distinct);
  }
}

// Beside a far line, with terms 2^-45 of others: double takes these for noise, double-double tells
// them.
TEST(Precision, WhatTermsDoubleHidesFinerPathsTell) {
  const System f =
      test::read("2\n (x - y - 67)*(x^2 - 4/10^16)*(x - 3);\n (x - y - 67)*(y + 7/4)*(y - 4/5);\n");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const SolveResult result = solve_with(f, Precision::automatic, seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.solutions.size(), 6U);
    EXPECT_GT(result.paths.on_positive_dimensional, 0U);
    EXPECT_FALSE(solve_with(f, Precision::double_precision, seed).complete);
  }
}

TEST(Precision, EachRungHasAName) {
  EXPECT_EQ(to_string(PathPrecision::double_precision), "double");
  EXPECT_EQ(to_string(PathPrecision::mixed), "mixed");
  EXPECT_EQ(to_string(PathPrecision::double_double), "double-double");
  EXPECT_EQ(to_string(PathPrecision::multiprecision), "multiprecision");
}

}  // namespace
}  // namespace moivre
