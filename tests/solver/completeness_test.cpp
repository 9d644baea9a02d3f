// SPDX-License-Identifier: MIT
// Does a result that does not add up to what exact algebra counts say so?
#include "completeness.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <memory>

#include "moivre/solver/trace.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"
#include "tracking.h"

namespace moivre::test {
namespace {

SolveResult with_roots(std::size_t roots, std::uint64_t multiplicity) {
  SolveResult result;
  result.solutions.resize(roots);
  for (Solution& root : result.solutions) root.multiplicity = multiplicity;
  return result;
}

class Contradiction : public testing::Test {
 protected:
  /// With so many roots, and so many different ones, by algebra.
  std::string of(const SolveResult& result, std::uint64_t dimension,
                 std::optional<std::uint64_t> points = std::nullopt) {
    run_.bounds.ring = {QuotientRing::Verdict::finite, dimension, std::nullopt, std::nullopt};
    run_.bounds.points = points;
    return contradiction_by_algebra(run_, roots_to_compare(run_), result).value_or("");
  }

  std::unique_ptr<Tracker> tracker_ = make_cvode_tracker();
  std::atomic<bool> stop_ = false;
  System f_ = read("2\n x^2 + y^2 - 5;\n x*y - 2;\n");
  Setting setting_{f_, *tracker_, SolveOptions{}, stop_};
  moivre::Run run_{setting_};
};

TEST_F(Contradiction, IsNoneWhereTheCountsAgree) {
  EXPECT_EQ(of(with_roots(4, 1), 4), "");
  EXPECT_EQ(of(with_roots(2, 2), 4, 2), "");
}

TEST_F(Contradiction, IsToldWhereARootIsMissing) {
  EXPECT_EQ(of(with_roots(3, 1), 4),
            "exact algebra counts 4 roots with their multiplicities, those found count 3");
}

TEST_F(Contradiction, IsToldWhereAMultiplicityIsTooLarge) {
  EXPECT_EQ(of(with_roots(2, 3), 4),
            "exact algebra counts 4 roots with their multiplicities, those found count 6");
}

TEST_F(Contradiction, IsToldWhereSimpleRootsPassForAMultipleOne) {
  EXPECT_EQ(of(with_roots(2, 2), 4, 4),
            "exact algebra counts 4 different roots, those found are 2");
}

TEST_F(Contradiction, IsToldWherePathsEndOnACurveThatIsNotThere) {
  SolveResult result = with_roots(4, 1);
  result.on_sets.emplace_back();
  EXPECT_EQ(of(result, 4), "exact algebra tells that no root lies on a curve, paths end as on one");
}

// Four paths lead to 0, which is exact: where all were told to be at infinity no bound proves that
// nothing is missing.
TEST(ExactRootsWithoutPaths, AreNoProofButAContradiction) {
  const auto tracker = make_cvode_tracker();
  const std::atomic<bool> stop{false};
  const System f = read("2\n x^2 + y^2;\n x*y;\n");
  const SolveOptions options;
  const Setting setting(f, *tracker, options, stop);
  moivre::Run run(setting);
  for (std::uint64_t path = 0; path < 4; ++path) run.table.enter_infinity(path, false);
  EXPECT_FALSE(settle_by_bound(run));
  EXPECT_FALSE(settle_by_bound(run));
  EXPECT_EQ(contradiction_by_algebra(run, roots_to_compare(run), SolveResult{}),
            "fewer paths end at a multiple root than it has to have");
  for (std::uint64_t path = 0; path < 4; ++path) {
    FailedPath failed;
    failed.path = path;
    run.table.enter_failure(failed);
  }
  EXPECT_TRUE(settle_by_bound(run));
  EXPECT_TRUE(run.bounds.met);
}

// What the digits of the file send to infinity may be a root of the file to the letter.
TEST_F(Contradiction, AllowsForEndsThatTheDigitsOfTheFileDoNotTell) {
  run_.table.enter_infinity(0, true);
  EXPECT_EQ(of(with_roots(3, 1), 4), "");
  EXPECT_NE(of(with_roots(2, 1), 4), "");
}

// Sixteen double roots with irrational coordinates: numerical ranks do not confirm them.
TEST(CountedRoots, AreDoubleWhereAlgebraCountsTheDifferentOnes) {
  const System f = read(
      "6\n"
      "-84*x1^3+252*x1^2*x2+756*x1^2*x4-252*x1^2*x5+504*x1^2*x6-252*x1*x2^2-1512*x1*x2*x4"
      "+504*x1*x2*x5-1008*x1*x2*x6-2268*x1*x4^2+1512*x1*x4*x5-3024*x1*x4*x6-252*x1*x5^2"
      "+1008*x1*x5*x6-1008*x1*x6^2+84*x2^3+756*x2^2*x4-252*x2^2*x5+504*x2^2*x6+2268*x2*x4^2"
      "-1512*x2*x4*x5+3024*x2*x4*x6+252*x2*x5^2-1008*x2*x5*x6+1008*x2*x6^2+2268*x4^3-2268*x4^2*x5"
      "+4536*x4^2*x6+756*x4*x5^2-3024*x4*x5*x6+3024*x4*x6^2-84*x5^3+504*x5^2*x6-1008*x5*x6^2"
      "+672*x6^3-204*x1^2+408*x1*x2+1224*x1*x4-408*x1*x5+816*x1*x6-204*x2^2-1224*x2*x4+408*x2*x5"
      "-816*x2*x6-1836*x4^2+1224*x4*x5-2448*x4*x6-204*x5^2+816*x5*x6-816*x6^2-156*x1+156*x2"
      "+468*x4-156*x5+312*x6-36;\n"
      "-9*x1^2+18*x1*x2+54*x1*x4-18*x1*x5+36*x1*x6-8*x2^2-50*x2*x4+16*x2*x5-36*x2*x6-77*x4^2"
      "+50*x4*x5-108*x4*x6-8*x5^2+36*x5*x6-36*x6^2+3*x1-3*x2-9*x4+3*x5-6*x6+4;\n"
      "6*x1^2-6*x1*x2-24*x1*x4+6*x1*x5-24*x1*x6+4*x2^2+4*x2*x3+22*x2*x4-8*x2*x5+12*x2*x6+x3^2"
      "+8*x3*x4-4*x3*x5+34*x4^2-22*x4*x5+48*x4*x6+4*x5^2-12*x5*x6+24*x6^2+4*x1-4*x2-12*x4+4*x5"
      "-8*x6-9;\n"
      "-12*x1*x2-6*x1*x3-24*x1*x4+12*x1*x5+5*x2^2-10*x2*x3+34*x2*x4-10*x2*x5+24*x2*x6-6*x3^2"
      "-14*x3*x4+10*x3*x5+12*x3*x6+49*x4^2-34*x4*x5+48*x4*x6+5*x5^2-24*x5*x6+18*x2+9*x3+36*x4"
      "-18*x5+4;\n"
      "6*x1*x2+3*x1*x3+12*x1*x4-6*x1*x5-48*x2^2-42*x2*x3-214*x2*x4+96*x2*x5-12*x2*x6-9*x3^2"
      "-95*x3*x4+42*x3*x5-6*x3*x6-236*x4^2+214*x4*x5-24*x4*x6-47*x5^2+12*x5*x6-4*x2-2*x3-8*x4"
      "+4*x5+8;\n"
      "-3*x1+22*x2+9*x3+40*x4-21*x5+10*x6+4;\n");
  const auto lanes = make_lane_tracker();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SolveResult result = solve(f, *lanes, with_seed(seed));
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.solutions.size(), 32U);
  }
}

// 12 simple roots, and three of multiplicity 3 with irrational coordinates: 21 in all. Eleven paths
// more lead to infinity, some of them too slowly to be told.
TEST(CountedRoots, EndTheDoubtsAboutOtherPaths) {
  const System f = read(
      "2\n -8*(8*y-6*x-3*x^2+1)*(3*y+2*x+7*x*y-4)+3*(8*y-6*x-3*x^2+1)*(3*y+2*x+7*x*y-4)^2"
      "+8*(8*y-6*x-3*x^2+1)^2*(3*y+2*x+7*x*y-4)-7*(8*y-6*x-3*x^2+1)^2*(3*y+2*x+7*x*y-4)^2;\n"
      " -3*(3*y+2*x+7*x*y-4)+2*(8*y-6*x-3*x^2+1)*(3*y+2*x+7*x*y-4)^2+9*(8*y-6*x-3*x^2+1)^2"
      "-8*(8*y-6*x-3*x^2+1)^2*(3*y+2*x+7*x*y-4)^2;\n");
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const SolveResult result = solve(f, *make_lane_tracker(), with_seed(seed));
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.completeness, RootCompleteness::shown);
    EXPECT_EQ(result.solutions.size(), 15U);
    EXPECT_EQ(sum_of_multiplicities(result), 21U);
  }
}

/// By lanes, with several seeds: all roots by proof, and no path that ends on a set.
void expect_proved_from_total_degree(const System& f, std::size_t roots) {
  const auto lanes = make_lane_tracker();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    SolveOptions options = with_seed(seed);
    options.start = StartKind::total_degree;
    const SolveResult result = solve(f, *lanes, options);
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
    EXPECT_EQ(result.solutions.size(), roots);
    EXPECT_TRUE(result.on_sets.empty());
  }
}

// With seed 5 a path jumps to a sheet at infinity beside it, 1e-12 before its end at a root of size
// 2e9 and condition 1e13.
TEST(CountedRoots, AreLookedForOnPathsThatAreSaidToEndAtInfinity) {
  const System f = read(
      "3\n400000*x1^2*x3-40000000*x1*x2^2-90*x1^2-4000000*x1*x2-500000000*x2^2-90*x2-200;\n"
      "30000*x1^2*x3+3*x1*x2*x3-7000*x1^2+200000000*x1*x3-100000000;\n"
      "-9000*x1*x2^2+100*x1*x3^2+100000000*x2^2*x3-90000*x2*x3^2-200*x1+80000*x3+8;\n");
  expect_proved_from_total_degree(f, 17);
}

// Paths that end where F all but vanishes along a set: algebra tells that there is none.
TEST(CountedRoots, LeaveNoSetBesideThem) {
  const System f = read(
      "2\n64*x1^2*x2^2-144*x1*x2^2+96*x1*x2+81*x2^2-108*x2+36.0000000004;\n"
      "-56*x1^2*x2-16*x1*x2^2+15*x1*x2+18*x2^2-36*x1+38*x2-39.9999999993;\n");
  expect_proved_from_total_degree(f, 4);
}

// Of size 1e39: x_0 is lost in the digits of double-double, and the other ten doubtful paths go to
// infinity.
TEST(CountedRoots, AreLookedForInMoreDigitsAsLongAsOneIsMissing) {
  const System f = read(
      "5\n8*x2^2-x2*x5+x3*x4-x3*x5+x1+3*x5-6;\n-x1^2+x2-2506*x3-9*x4+1;\n"
      "7503*x3*x4-1658*x3*x5-5381*x2-1607*x3-553;\n8661*x2*x5-1312*x1-4*x2-x3+x4+4*x5-1;\n"
      "-4132*x1*x2-x3*x4-4*x4*x5-x4-1;\n");
  const auto lanes = make_lane_tracker();
  SolveOptions options = with_seed(7);
  options.start = StartKind::total_degree;
  const SolveResult result = solve(f, *lanes, options);
  EXPECT_EQ(result.solutions.size(), 22U);
  ASSERT_TRUE(result.bound) << result.message;
  EXPECT_EQ(result.bound->kind, BoundKind::quotient_ring);
}

// Of size 4.6e34, without a doubtful path: double and CVODE call its end infinity.
TEST(CountedRoots, AreLookedForAmongEndsAtInfinityInMoreDigits) {
  const System f = read(
      "5\n800*x1*x4+900000*x2*x5-7000000*x3*x4-5000;\n1000000*x2-10*x3+3000000*x5+800000;\n"
      "5*x1^2-4000000*x2*x5+3*x3*x4-900000000*x4^2-300*x4*x5+700000000*x2-80000*x3-1000*x5-"
      "8000000;\n30*x2*x4+30000000*x1-20*x4+6000000;\n"
      "-900000000*x1*x3+5000*x2^2-7000000*x2*x4-30000;\n");
  const auto lanes = make_lane_tracker();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SolveResult result = solve(f, *lanes, with_seed(seed));
    EXPECT_EQ(result.solutions.size(), 14U);
    EXPECT_EQ(result.completeness, RootCompleteness::proved) << result.message;
  }
}

// Of size 9e7, and its path meets one to infinity 1e-16 before t = 1: two sheets with one mean,
// told as a double root.
TEST(CountedRoots, AreLookedForAmongMultipleEndsInMoreDigits) {
  const System f = read(
      "2\n500000*x^2*y - 2000000*x*y^2 + 600000*x*y - 30*y + 70000;\n"
      "-10000*x^2*y^3 + 400000000*x^2*y^2 + 60*x*y^4 - 4*x + 80000*y^2 - 50;\n");
  const auto lanes = make_lane_tracker();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SolveOptions options = with_seed(seed);
    options.start = StartKind::multihomogeneous;
    const SolveResult result = solve(f, *lanes, options);
    EXPECT_EQ(result.solutions.size(), 9U);
    EXPECT_EQ(result.completeness, RootCompleteness::proved) << result.message;
  }
}

// p = 2^61 - 31 is prime: modulo p the first has a double root at 0, the second one beside two
// others.
TEST(CountedRoots, AreNotThoseModuloAPrimeThatTheSystemWasMadeFor) {
  const auto tracker = make_lane_tracker();
  const SolveResult large = solve(read("1\n x^2 - 2305843009213693921;\n"), *tracker);
  EXPECT_EQ(large.solutions.size(), 2U);
  EXPECT_EQ(large.completeness, RootCompleteness::proved);
  const SolveResult small =
      solve(read("1\n (x - 1)*(x - 2)*(x^2 - 2305843009213693921e-40);\n"), *tracker);
  EXPECT_EQ(small.solutions.size(), 4U);
  EXPECT_EQ(small.completeness, RootCompleteness::proved);
}

// 720 paths of which 564 end at infinity: no circle is walked when the others have met a bound.
TEST(WaitingPaths, WalkNoCircleWhereTheOthersMeetABound) {
  const auto lanes = make_lane_tracker();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SolveOptions options = with_seed(seed);
    options.start = StartKind::total_degree;
    const SolveResult result = solve(system_of(problem("cyclic-6")), *lanes, options);
    EXPECT_EQ(result.solutions.size(), 156U);
    EXPECT_TRUE(result.bound);
    std::size_t left = 0;
    for (const PathRecord& path : result.ledger) {
      if (path.verdict != PathVerdict::not_needed) continue;
      ++left;
      EXPECT_EQ(path.followed, 1);
      EXPECT_LT(path.steps, 400U);
    }
    EXPECT_EQ(left, 564U);
  }
}

// A root of the file to the letter that its digits do not determine is none: only of exact numbers
// a proof is enough.
TEST(WaitingPaths, AreThoseWhoseProofTheDigitsOfTheFileDoNotBear) {
  const std::atomic<bool> stop{false};
  const auto lanes = make_lane_tracker();
  const auto condition = [&](const System& f) {
    SolveOptions options = with_seed(1);
    options.start = StartKind::total_degree;
    const Setting setting(f, *lanes, options, stop);
    return endgame_for(setting, Effort::regular_ends).ends.regular_condition;
  };
  EXPECT_EQ(condition(read("2\n x^2 + 3*y^2 - 5;\n x*y - 2;\n")),
            std::numeric_limits<double>::infinity());
  const double rounded = condition(read("2\n x^2 + 0.333333333333333*y^2 - 5;\n x*y - 2;\n"));
  EXPECT_GT(rounded, 1e8);
  EXPECT_LT(rounded, 1e10);
}

// What is followed afterwards, in doubt, gets a verdict; nothing waits then.
TEST(WaitingPaths, AreOnlyThoseOfAnEffortThatIsUnderWay) {
  const System f = system_of(problem("cyclic-5"));
  SolveOptions options = with_seed(1);
  options.start = StartKind::total_degree;
  const std::atomic<bool> stop{false};
  const auto lanes = make_lane_tracker();
  const Setting setting(f, *lanes, options, stop);
  moivre::Run run(setting);
  track_all(run);
  EXPECT_EQ(run.effort, Effort::all_steps);
  EXPECT_EQ(run.waiting.size(), 50U);
  EXPECT_EQ(run.table.tracked(), 70U);
  track_waiting(run, Effort::few_steps);
  EXPECT_EQ(run.effort, Effort::all_steps);
  EXPECT_EQ(run.waiting.size() + run.table.tracked(), 120U);
  track_waiting(run, Effort::all_steps);
  EXPECT_TRUE(run.waiting.empty());
  EXPECT_EQ(run.table.tracked(), 120U);
}

// A curve beside the roots: no bound is met, and few paths go on with all their steps.
TEST(WaitingPaths, GoOnWhereNoBoundIsMet) {
  const System f = read("2\n(x^2 + y^2 - 5)*(x - 3)^3;\n(x*y - 2)*(x - 3)^3;\n");
  const SolveResult result = solve(f, *make_lane_tracker(), with_seed(1));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.solutions.size(), 4U);
}

// 16 roots and no bound that is less than 288: the others are taken up where they stood, and end
// where they do without a wait. Roots of the file to the letter that its digits do not tell from
// infinity are no roots.
TEST(WaitingPaths, EndWhereTheyDoWithoutAWait) {
  constexpr std::size_t kStride = 8;  // 128 of the 1024 paths, half a second
  const System f = system_of(problem("ipp2"));
  const auto lanes = make_lane_tracker();
  const std::atomic<bool> go_on{false};
  const SolveOptions options = with_seed(1);
  const SolveResult waited = solve(f, *lanes, options);
  EXPECT_EQ(waited.solutions.size(), 16U);
  std::size_t again = 0;
  for (const PathRecord& record : waited.ledger) again += record.followed > 1 ? 1 : 0;
  EXPECT_LT(again, 5U);
  for (std::size_t path = 0; path < waited.ledger.size(); path += kStride) {
    const Trace alone = trace_path(f, *lanes, options, path, go_on);
    const PathVerdict verdict = waited.ledger[path].verdict;
    EXPECT_EQ(verdict == PathVerdict::finite, alone.end.status == PathStatus::finite) << path;
    EXPECT_EQ(verdict == PathVerdict::at_infinity || verdict == PathVerdict::as_rounded,
              alone.end.status == PathStatus::at_infinity)
        << path;
  }
}

}  // namespace
}  // namespace moivre::test
