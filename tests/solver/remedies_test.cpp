// SPDX-License-Identifier: MIT
// What does each way to settle what is open (settle.h) find that the others do not?
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

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

}  // namespace
}  // namespace moivre
