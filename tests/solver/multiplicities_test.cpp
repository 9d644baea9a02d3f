// SPDX-License-Identifier: MIT
// Is a root said to be multiple only where exact algebra says so, and are roots nearer than digits
// part told as what is known of them?
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre::test {
namespace {

SolveResult solved(const std::string& text, std::uint64_t seed = 1,
                   StartKind start = StartKind::automatic) {
  SolveOptions options;
  options.seed = seed;
  options.start = start;
  return solve(read(text), *make_lane_tracker(), options);
}

std::vector<std::uint64_t> multiplicities(const SolveResult& result) {
  std::vector<std::uint64_t> list;
  for (const Solution& root : result.solutions) list.push_back(root.multiplicity);
  std::sort(list.begin(), list.end());
  return list;
}

// Two roots some 3^-61 apart near 1/3; and, of a degree at which roots are not isolated at once,
// 3^-129 and, nearer than double has numbers, 999^-129.
TEST(NearRoots, OfOneUnknownAreAllProvedOrACluster) {
  const SolveResult all = solved("1\nx^120 - (3*x - 1)^2;\n");
  EXPECT_TRUE(all.complete) << all.message;
  EXPECT_EQ(all.solutions.size(), 120U);
  EXPECT_EQ(all.completeness, RootCompleteness::proved);
  const SolveResult large = solved("1\nx^256 - (3*x - 1)^2;\n");
  EXPECT_TRUE(large.complete) << large.message;
  EXPECT_EQ(large.solutions.size(), 256U);
  const SolveResult nearer = solved("1\nx^256 - (999*x - 1)^2;\n");
  EXPECT_EQ(nearer.solutions.size(), 255U);
  EXPECT_EQ(std::count_if(nearer.solutions.begin(), nearer.solutions.end(),
                          [](const Solution& root) { return root.cluster; }),
            1);
}

TEST(NearRoots, OfAQuadraticAreProvedHoweverNearTheyAre) {
  for (const char* shift : {"7e-36", "7e-42", "7e-46", "7e-60", "7e-120"}) {
    const SolveResult result = solved(std::string("1\nu^2 - 140*u + 4900 - ") + shift + ";\n");
    EXPECT_TRUE(result.complete) << shift;
    EXPECT_EQ(result.solutions.size(), 2U) << shift;
    EXPECT_EQ(result.completeness, RootCompleteness::proved) << shift;
  }
}

// y is eliminated: what is left is a quadratic with roots 1e-23 of their size apart.
TEST(NearRoots, AreProvedWhereEliminationLeavesOneUnknown) {
  const SolveResult result = solved(
      "2\nx^2 - 140*x*y - y^3 + 4900*y^2;\n1427247692705959881058285969449495136382746624*y - "
      "1;\n");
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.solutions.size(), 2U);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
}

// Two pairs of simple roots 3e-31 apart, and a degree that keeps exact algebra from counting.
TEST(NearRoots, ThatNothingPartsAreClustersAndNotMultiple) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const SolveResult result =
        solved("2\nz*(x + 3) - x^256 + 1;\n(2*x^2 - 1)^2*(2*x + 1) - 1/10^60*x;\n", seed);
    for (const Solution& root : result.solutions) {
      if (root.multiplicity == 1) continue;
      EXPECT_TRUE(root.cluster);
      EXPECT_GE(root.radius, 3e-31);
    }
    if (!result.complete) continue;
    const auto all = multiplicities(result);
    EXPECT_EQ(std::accumulate(all.begin(), all.end(), std::uint64_t{0}), 5U);
  }
}

// A double root that is exact, one at an irrational point that algebra counts, and one of one
// unknown beyond that algebra.
TEST(MultipleRoots, AreToldAsSuchWhereExactAlgebraCan) {
  for (const char* text :
       {"2\n(x - 1)^2*(x + 2);\ny - x^2 + y^2;\n", "2\n(x^2 - 2)^2*(x + 1) + 0*y;\ny^2 - x - 7;\n",
        "1\n(x^3 - x - 1)^2*(x^260 - 3);\n"}) {
    const SolveResult result = solved(text);
    EXPECT_TRUE(result.complete) << text << result.message;
    std::size_t multiple = 0;
    for (const Solution& root : result.solutions) {
      EXPECT_FALSE(root.cluster) << text;
      multiple += root.multiplicity > 1;
    }
    EXPECT_GT(multiple, 0U) << text;
  }
}

// Four pairs of double roots 7e-9 apart beside the line x - y = 5, where nothing counts roots.
TEST(MultipleRoots, BesideCurvesAreClustersWithinTheirRadius) {
  const SolveResult result =
      solved("2\n(x - y - 5)*((x^2 - 2)^2 - 1/10^16);\n(x - y - 5)*(y^2 - 3)^2*(x + 7);\n");
  for (const Solution& root : result.solutions) {
    if (root.multiplicity == 1) continue;
    EXPECT_TRUE(root.cluster);
    EXPECT_GE(root.radius, 3.5e-9);
  }
}

// At (+-sqrt 2, +-sqrt 3) the third equation is -1e-16 (x - y - 5).
TEST(SpareEquations, ThatAllButVanishMakeNoRoot) {
  const auto with = [](const std::string& third) {
    return "3 2\n(x-y-5)*(x^2-2);\n(x-y-5)*(y^2-3);\n(x-y-5)*(" + third + ");\n";
  };
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SolveResult none = solved(with("(x^2-2)*(y-11) - 1/10^16"), seed);
    EXPECT_TRUE(!none.complete || none.solutions.empty()) << seed;
    const SolveResult four = solved(with("(x^2-2)*(y-11)"), seed);
    EXPECT_TRUE(!four.complete || four.solutions.size() == 4U) << seed;
  }
}

TEST(PathsNotNeeded, AreCountedAsSuchAndNotAtInfinity) {
  SolveOptions options;
  options.start = StartKind::total_degree;
  const SolveResult result = solve(system_of(problem("eco-8")), *make_lane_tracker(), options);
  EXPECT_EQ(result.paths.finite, 64U);
  EXPECT_GT(result.paths.not_needed, 0U);
  EXPECT_EQ(result.paths.tracked, result.paths.finite + result.paths.at_infinity +
                                      result.paths.failed + result.paths.not_needed);
  EXPECT_EQ(result.message, "every path was decided or not needed");
}

}  // namespace
}  // namespace moivre::test
