// SPDX-License-Identifier: MIT
// Does exact algebra find the roots that no path has shown, and which it counts?
#include <gtest/gtest.h>

#include "moivre/polynomial/read.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre::test {
namespace {

/// Two coupled oscillators: nine roots, of sizes from 1e-16 to 1e7; 72 of 81 paths go to infinity,
/// very slowly, where the two forms x^2 + y^2 all but vanish together. a: the frequency of the
/// drive.
System oscillators(const std::string& a) {
  std::string text = R"(4
4.5*x1 - (9/2)*x1*A^2 + 1.5*x1*x3^2 + 1.5*x1*x4^2 + 0.00015*x2*A + 19.5*x2^2*x1 + 0.00375*x2^3*A + 0.15*x4^2*x3 + 0.00375*x2*x1^2*A + 19.5*x1^3 - 0.05*x3^3;
4.5*x2 - 0.00015*x1*A - 0.00375*x1^3*A - (9/2)*x2*A^2 + 19.5*x2*x1^2 + 1.5*x2*x3^2 + 1.5*x2*x4^2 - 0.15*x4*x3^2 - 0.00375*x2^2*x1*A + 19.5*x2^3 + 0.05*x4^3;
-1.5e-05 + (1/2)*x3 - 0.15*x1*x3^2 + 0.15*x1*x4^2 + 1.5*x1^2*x3 + 1.5*x2^2*x3 - (1/2)*x3*A^2 + 1e-05*x4*A + (3/8)*x4^2*x3 + 2.5e-05*x4^3*A - 0.3*x2*x4*x3 + 2.5e-05*x4*x3^2*A + (3/8)*x3^3;
(1/2)*x4 + 1.5*x1^2*x4 - 0.15*x2*x3^2 + 0.15*x2*x4^2 + 1.5*x2^2*x4 - 1e-05*x3*A - 2.5e-05*x3^3*A - (1/2)*x4*A^2 + (3/8)*x4*x3^2 + 0.3*x1*x4*x3 - 2.5e-05*x4^2*x3*A + (3/8)*x4^3;
)";
  for (std::size_t at = text.find('A'); at != std::string::npos; at = text.find('A')) {
    text.replace(at, 1, "(" + a + ")");
  }
  return read_system({"oscillators", text});
}

void expect_nine_proved(const SolveResult& result) {
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.solutions.size(), 9U);
  ASSERT_EQ(result.completeness, RootCompleteness::proved);
  EXPECT_EQ(result.bound->kind, BoundKind::quotient_ring);
  for (const Solution& root : result.solutions) EXPECT_EQ(root.certified, true);
  EXPECT_EQ(result.paths.finite + result.paths.not_needed, 81U);
}

TEST(MissingRoots, OfPathsThatNoDigitsDecideAreFoundByExactAlgebra) {
  const auto lanes = make_lane_tracker();
  for (const char* a : {"0.9", "1.1"}) {
    for (const std::uint64_t seed : {1U, 2U}) {
      SCOPED_TRACE(a);
      expect_nine_proved(solve(oscillators(a), *lanes, with_seed(seed)));
    }
  }
}

TEST(MissingRoots, OfComplexCoefficientsAreFoundToo) {
  const auto lanes = make_lane_tracker();
  expect_nine_proved(solve(oscillators("0.81 + 0.38*i"), *lanes, with_seed(1)));
}

TEST(MissingRoots, AreFoundBesideTheReferenceTrackerToo) {
  const auto lanes = make_lane_tracker();
  SolveOptions options = with_seed(1);
  options.fallback = lanes.get();
  expect_nine_proved(solve_with_cvode(oscillators("1.1"), options));
}

// One root of thirteen lies where no path is seen to end: exact algebra has it, and a path that was
// seen elsewhere is entered for it.
TEST(MissingRoots, CountAPathThatNobodySawThereAsOneByCount) {
  const System f = read_system(
      {"far-root",
       "2\n 600000000*x^3*y^2-80000000*x^2*y^3-600*x^2+9000000*x*y^3-20;\n"
       " -10*x^3*y^3+10000*x^2*y^2-700000*x^2*y-300*x^2+700000000*x*y^2+80000*x-3000;\n"});
  const auto lanes = make_lane_tracker();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    SolveOptions options = with_seed(seed);
    options.start = StartKind::total_degree;
    const SolveResult result = solve(f, *lanes, options);
    EXPECT_EQ(result.solutions.size(), 13U);
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
    expect_conservation(result);
    EXPECT_EQ(result.paths.by_count, 1U);
  }
}

// Four roots of size 3e6 beside double ones at infinity: a change of the last digits moves two
// there.
TEST(MissingRoots, OfPathsAtInfinityWithinTheDigitsAreThoseOfTheFileToTheLetter) {
  const System f = read_system(
      {"near-multiple",
       "3\n 49*x1^2*x2^2-70*x1*x2+25.000000000001;\n"
       " 64*x1^2-96*x1*x3+36*x3^2+80*x1-60*x3+25.000000000001;\n"
       " 14*x1^2*x2-14*x1*x2^2-63*x1*x2*x3-57*x1*x2-8*x3^2-10*x1+10*x2+45*x3+53.000000000004;\n"});
  const auto lanes = make_lane_tracker();
  for (const std::uint64_t seed : {1U, 2U}) {
    SCOPED_TRACE(seed);
    SolveOptions options = with_seed(seed);
    options.start = StartKind::polyhedral;
    const SolveResult result = solve(f, *lanes, options);
    EXPECT_EQ(result.solutions.size(), 12U);
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
  }
}

}  // namespace
}  // namespace moivre::test
