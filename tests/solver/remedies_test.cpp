// SPDX-License-Identifier: MIT
// What does each way to settle what is open (settle.h) find that the others do not?
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "account.h"
#include "beside_sets.h"
#include "clusters.h"
#include "isolated.h"
#include "missing_roots.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "more_digits.h"
#include "multiplicities.h"
#include "problem_set.h"
#include "settle.h"
#include "tracking.h"

namespace moivre {
namespace {

using test::read;
using test::with_seed;

/// Five simple roots: the four at x near +-1/sqrt(2) come in pairs, 1e-30 apart.
System near_pairs(int degree) {
  return read("2\n z*(x+3) - x^" + std::to_string(degree) +
              " + 1;\n (2*x^2-1)^2*(2*x+1) - 1/10^60*x;\n");
}

std::size_t certified_roots(const SolveResult& result) {
  return static_cast<std::size_t>(
      std::count_if(result.solutions.begin(), result.solutions.end(),
                    [](const Solution& root) { return root.certified == true; }));
}

TEST(Remedies, PathsWithoutDigitsGoOnTogetherInDoubleDoubleBeforeOneIsFollowedWithCare) {
  SolveOptions options = with_seed(1);
  options.start = StartKind::total_degree;
  const SolveResult result = solve(near_pairs(24), *make_lane_tracker(), options);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  EXPECT_EQ(certified_roots(result), 5U);
  // With smaller steps first it is 2.9 million steps, and ten times the processor time.
  EXPECT_LT(result.work.accepted, 2'200'000U);
}

TEST(Remedies, RootsThatPassForOneInDoubleDoubleArePartedInMoreDigits) {
  const SolveResult result = solve(near_pairs(256), *make_lane_tracker(), with_seed(1));
  EXPECT_GE(certified_roots(result), 3U);
}

TEST(Remedies, SimpleRootsThatOnlyMoreDigitsShowAreTold) {
  const System mignotte = read("1\n x^256 - (3*x - 1)^2;\n");
  const SolveResult result = solve(mignotte, *make_lane_tracker(), with_seed(3));
  EXPECT_EQ(result.solutions.size(), 256U);
  EXPECT_EQ(certified_roots(result), 256U);
}

TEST(Remedies, APairOfRootsBesideALineIsPartedBeforeItPassesForPointsOfTheLine) {
  const System pair = read("2\n x*y*(x + 2/10^12);\n x*y*((y - 3/7 + 9/10^12)^2 - 9/10^25);\n");
  const SolveResult result = solve(pair, *make_lane_tracker(), with_seed(1));
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  EXPECT_EQ(certified_roots(result), 2U);
}

// Three simple roots at y = 3. On x y = 1 the equations are 1e-20 of their terms, and of so many
// unknowns exact algebra counts no roots.
TEST(Remedies, RootsBesideACurveOnWhichTheEquationsAllButVanishAreNoPointsOfIt) {
  std::string text = "16\n (x*y - 1)^2*(x - 2) + 3/10^20*(2 - x*y);\n (x*y - 1)*(y - 3);\n";
  for (int i = 0; i < 14; ++i) {
    text += " u" + std::to_string(i) + "*(x + " + std::to_string(i + 4) + ") - 1;\n";
  }
  const SolveResult result = solve(read(text), *make_lane_tracker(), with_seed(1));
  EXPECT_EQ(certified_roots(result), 3U);
  EXPECT_TRUE(result.on_sets.empty());
}

// Where a curve lies in the plane x = 0 exact algebra counts no roots. Double-double leaves ten of
// the forty without an end.
TEST(Remedies, TwentyNeighboursBesideACurveAreFollowedInMoreDigitsThanDoubleDouble) {
  std::string wilkinson = "x";
  for (int k = 1; k <= 20; ++k) wilkinson += "*(y - " + std::to_string(k) + ")";
  const System f = read("3\n " + wilkinson + ";\n x*(x - 2 - y);\n z^2 - y*z - 3 - x;\n");
  for (const std::uint64_t seed : {1U, 2U}) {
    const SolveResult result = solve(f, *make_lane_tracker(), with_seed(seed));
    EXPECT_EQ(result.completeness, RootCompleteness::proved) << seed;
    EXPECT_EQ(certified_roots(result), 40U) << seed;
  }
}

// Beside a simple root no circle closes around the sixfold one alone.
TEST(Remedies, MultipleRootsThatNoPathShowsAreToldByTheQuotientRing) {
  const System f = read(
      "2\n (u - 2*v - 15/7)^6*(u - 2*v - 15/7 - 6/10^4);\n"
      " (3*v - u)*((u - 2*v)^2 + 4) - 8*(u - 2*v) + 5;\n");
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    for (const auto& tracker : {make_lane_tracker(), make_cvode_tracker()}) {
      const SolveResult result = solve(f, *tracker, with_seed(seed));
      SCOPED_TRACE(tracker->kind() + ", seed " + std::to_string(seed));
      EXPECT_EQ(result.completeness, RootCompleteness::proved);
      ASSERT_EQ(result.solutions.size(), 2U);
      EXPECT_EQ(test::sum_of_multiplicities(result), 7U);
      for (const Solution& root : result.solutions) {
        EXPECT_FALSE(root.cluster);
        const double x = (root.x[0] - 2.0 * root.x[1]).real();
        EXPECT_NEAR(x, root.multiplicity == 6 ? 15.0 / 7 : 15.0 / 7 + 6e-4, 1e-12);
      }
    }
  }
}

// The two certified roots lie apart from the curve x^2 = 2 y, z = 2, on which three sheets meet
// everywhere.
TEST(Remedies, PointsOfACurveOfMultipleRootsAreNoClusters) {
  const System f = read("3\n (x^2-2*y)^2*(z+x);\n (x^2-2*y)*(z+1);\n (z-2)^3 + (x^2-2*y)^2;\n");
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SolveResult result = solve(f, *make_lane_tracker(), with_seed(seed));
    EXPECT_EQ(result.solutions.size(), 2U) << seed;
    EXPECT_EQ(certified_roots(result), 2U) << seed;
  }
}

TEST(Remedies, ClustersThatNoCountConfirmsArePartedInMoreDigits) {
  const SolveResult result = solve(near_pairs(300), *make_lane_tracker(), with_seed(1));
  EXPECT_GE(certified_roots(result), 3U);
}

// Paths that have jumped to one of the 140 simple roots, and two that have no end, are those to the
// double roots: all roots are isolated, and no other path is left.
TEST(Remedies, IsolatedRootsThatNoPathHasAreThoseOfPathsThatHaveJumped) {
  const System f = read("1\n (x^140 - (3*x - 1)^2)*((x - 1/3)^2 - 1/10^6)^2;\n");
  const auto lanes = make_lane_tracker();
  SolveOptions options = with_seed(2);
  options.fallback = lanes.get();
  const SolveResult result = solve(f, *make_cvode_tracker(), options);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
  EXPECT_EQ(certified_roots(result), 140U);
  EXPECT_EQ(result.solutions.size(), 142U);
  EXPECT_EQ(test::sum_of_multiplicities(result), 144U);
}

/// A system of which a run without the remedy tells less.
struct Need {
  Remedy remedy;
  const char* finds;  ///< what the others do not
  const char* system;
  bool by_cvode = false;
  std::uint64_t seed = 1;
  std::int64_t most_steps = 20000;  ///< of a path's segment, of the lanes
};

const Need kNeeds[] = {
    {isolate_roots, "DigitsOfRootsNearToEachOther",
     "2\n (x - 1)*(x - 1 - 1/10^9);\n y - 10^6*x;\n"},
    {part_in_double_double, "ThreeNearRootsBesideACurve",
     "3\n x*(y - 1 - 1/10^8)*(y - 1 - 14/10^8)*(y - 1 - 16/10^8);\n x*(x - 2 - y);\n"
     " z^2 - y*z - 3 - x;\n"},
    {raise_failed_paths, "EndsOfManyPathsThatSmallerStepsDoNotHelp",
     "2\n ((u - 3*v) + 9/5)^4*((u - 3*v) + 9/5 - 5/10^8)*((u - 3*v) + 4)^4*"
     "((u - 3*v) + 4 - 7/10^15);\n (10*v - 3*u)^2 - 2 - (u - 3*v)^2/97;\n"},
    {follow_in_smaller_steps, "EndsOfPathsWhoseBudgetOfStepsIsSpent",
     "2\n x^5 + 3*x*y^2 - 7;\n y^5 - 2*x^2*y + 4;\n", false, 1, 20},
    {raise_to_double_double, "PointsOfACurve",
     "2\n 7*x^2 - 9*y + 2;\n"
     " -56*x^3*y + 35*x^2*y^2 - 21*x^2*y + 72*x*y^2 - 45*y^3 + 56*x^2 - 16*x*y + 37*y^2 - 78*y + "
     "16;\n",
     true, 2},
    {give_missing_roots, "RootsThatThePathsDoNotTell",
     "2\n"
     " ((u + (3)*v) - (-1/7))^2*((u + (3)*v) - (-1/7) - 4/10^26);\n"
     " ((-1)*u + (-2)*v)*((u + (3)*v)^2 + 2) - 7*(u + (3)*v) + 3;\n"},
    {raise_to_more_digits, "ThreeRoots1e41ApartWhereNoneIsIsolated", "1\n x^256 - (3*x - 1)^3;\n"},
    {part_clusters_in_more_bits, "RootsThatNoCountTellsFromOne",
     "2\n z*(x + 3) - x^300 + 1;\n (2*x^2 - 1)^2*(2*x + 1) - 1/10^60*x;\n"},
    {isolate_roots, "MultipleRootsBesideMoreSimpleOnesThanAreIsolated",
     "1\n (x^3 - x - 1)^2*(x^260 - 3);\n"},
    {look_beside_sets, "ASimpleRootNearALine",
     "2\n"
     " -136*x^3 + 242*x^2*y - 124*x*y^2 + 18*y^3 - 27624999997/62500000*x^2 + "
     "26799999997/50000000*x*y - 35499999997/250000000*y^2 - 118999999973/250000000*x + "
     "36749999991/125000000*y - 8499999997/50000000;\n"
     " 136*x^2 - 55*x*y - 9*y^2 + 16999999997/62500000*x - 27500000003/500000000*y + "
     "8499999997/62500000;\n"},
    {look_at_blurred_sets, "RootsOnACurveOnWhichTheEquationsAllButVanish",
     "16\n (x*y - 1)^2*(x - 2) + 3/10^20*(2 - x*y);\n (x*y - 1)*(y - 3);\n"
     " u0*(x + 4) - 1;\n u1*(x + 5) - 1;\n u2*(x + 6) - 1;\n u3*(x + 7) - 1;\n"
     " u4*(x + 8) - 1;\n u5*(x + 9) - 1;\n u6*(x + 10) - 1;\n u7*(x + 11) - 1;\n"
     " u8*(x + 12) - 1;\n u9*(x + 13) - 1;\n v0*(x + 14) - 1;\n v1*(x + 15) - 1;\n"
     " v2*(x + 16) - 1;\n v3*(x + 17) - 1;\n"},
    {part_clusters, "NoClustersOnACurveOfMultipleRoots",
     "3\n (x^2 - 2*y)^2*(z + x);\n (x^2 - 2*y)*(z + 1);\n (z - 2)^3 + (x^2 - 2*y)^2;\n"},
    {raise_after_contradiction, "ALargeRootAmongEndsAtInfinity",
     "5\n 800*x1*x4 + 900000*x2*x5 - 7000000*x3*x4 - 5000;\n"
     " 1000000*x2 - 10*x3 + 3000000*x5 + 800000;\n"
     " 5*x1^2 - 4000000*x2*x5 + 3*x3*x4 - 900000000*x4^2 - 300*x4*x5 + 700000000*x2 - 80000*x3 - "
     "1000*x5 - 8000000;\n"
     " 30*x2*x4 + 30000000*x1 - 20*x4 + 6000000;\n"
     " -900000000*x1*x3 + 5000*x2^2 - 7000000*x2*x4 - 30000;\n"},
};

SolveResult solve_with(std::span<const Remedy> table, const Need& need) {
  const System f = read(need.system);
  const auto lanes = make_lane_tracker({.maximum_steps = need.most_steps});
  const auto cvode = make_cvode_tracker();
  const auto& [tracker, other] = need.by_cvode ? std::tie(cvode, lanes) : std::tie(lanes, cvode);
  SolveOptions options = with_seed(need.seed);
  options.fallback = other.get();
  const std::atomic<bool> stop{false};
  const Setting setting(f, *tracker, options, stop);
  Run run(setting);
  track_to_ends(run);
  settle(run, table);
  count_ends(run);
  SolveResult result;
  close_account(run, result);
  return result;
}

std::size_t clusters(const SolveResult& result) {
  return static_cast<std::size_t>(std::count_if(result.solutions.begin(), result.solutions.end(),
                                                [](const Solution& root) { return root.cluster; }));
}

double worst_accuracy(const SolveResult& result) {
  double worst = 0;
  for (const Solution& root : result.solutions) worst = std::max(worst, root.accuracy);
  return worst;
}

bool tells_less(const SolveResult& result, const SolveResult& whole) {
  return result.complete < whole.complete || certified_roots(result) < certified_roots(whole) ||
         clusters(result) > clusters(whole) || result.on_sets.size() > whole.on_sets.size() ||
         worst_accuracy(result) > 1000 * worst_accuracy(whole);
}

class RowOfRemedies : public testing::TestWithParam<std::size_t> {};

// Or as much at twice the cost, where that is all that a remedy is for.
TEST_P(RowOfRemedies, IsNeeded) {
  const std::size_t row = GetParam();
  const Need& need = kNeeds[row];
  const std::span<const Remedy> table = remedies();
  ASSERT_EQ(table[row], need.remedy);
  std::vector<Remedy> others(table.begin(), table.end());
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(row));
  const SolveResult whole = solve_with(table, need);
  const SolveResult result = solve_with(others, need);
  EXPECT_TRUE(tells_less(result, whole) || result.work.accepted > 2 * whole.work.accepted);
}

INSTANTIATE_TEST_SUITE_P(Finds, RowOfRemedies, testing::Range<std::size_t>(0, std::size(kNeeds)),
                         [](const auto& row) { return std::string(kNeeds[row.param].finds); });

TEST(Remedies, EachHaveASystemThatNeedsThem) { EXPECT_EQ(remedies().size(), std::size(kNeeds)); }

}  // namespace
}  // namespace moivre
