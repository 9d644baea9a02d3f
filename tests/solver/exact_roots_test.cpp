// SPDX-License-Identifier: MIT
// Are roots that exact algebra can count told with their multiplicity, however badly their paths
// end?
#include <gtest/gtest.h>

#include "problem_set.h"

namespace moivre::test {
namespace {

/// Complete by proof, with this one root, so often.
void expect_one_root(const std::string& text, const Point& x, std::uint64_t multiplicity) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SolveResult result = solve_with_cvode(read(text), with_seed(seed));
    EXPECT_TRUE(result.complete) << text;
    EXPECT_EQ(result.completeness, RootCompleteness::proved) << text;
    ASSERT_EQ(result.solutions.size(), 1U) << text;
    EXPECT_EQ(result.solutions[0].multiplicity, multiplicity) << text;
    EXPECT_LT(result.solutions[0].residual, 1e-15) << text;
    for (std::size_t k = 0; k < x.size(); ++k) {
      EXPECT_NEAR(std::abs(result.solutions[0].x[k] - x[k]), 0, 1e-15) << text;
    }
  }
}

TEST(ExactRoots, OfAPowerThatNoDoubleTells) { expect_one_root("1\n (x + 1)^40;\n", {-1}, 40); }

// Cycles of different winding numbers end at one point.
TEST(ExactRoots, OfTwoCurvesThatTouchSingularly) {
  expect_one_root("2\n (x - 1)^3*(y - 2)^2;\n x*y - 2;\n", {1, 2}, 5);
}

TEST(ExactRoots, ThatNoDoubleHolds) {
  expect_one_root("1\n (3*x - 1)^20;\n", {1.0 / 3}, 20);
  expect_one_root("2\n (7*x - 2*y)^6;\n y - 3/7;\n", {6.0 / 49, 3.0 / 7}, 6);
}

// 17 times 0, twice a point of denominators 410758 and 6962, and four simple roots: the mixed
// volume.
TEST(ExactRoots, OfLongDenominators) {
  const System f = read(
      "3\n -3156*x^2*y + 118*x*z^2 + y^3 + 5*y^2*z - 9*x^2;\n"
      " 9*y*z^2 + 8*z^3 + x^2 + 9959*x*y + 7*x*z;\n -6*x*y^2 - 4*y^2*z;\n");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SolveResult result = solve_with_cvode(f, with_seed(seed));
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
    EXPECT_EQ(result.solutions.size(), 6U);
    for (const Solution& root : result.solutions) EXPECT_LT(root.residual, 1e-15);
  }
}

// Ten roots 1e-6 around 1: in double-double their paths tell one root of multiplicity 10 there, but
// 1 is no root.
TEST(ExactRoots, AreNotMadeOfPointsThatAreNearRoots) {
  SolveOptions options = with_seed(1);
  options.precision = Precision::double_precision;
  const SolveResult result = solve_with_cvode(read("1\n (x - 1)^10 - 1e-60*i;\n"), options);
  EXPECT_TRUE(!result.complete || result.solutions.size() == 10U);
  for (const Solution& root : result.solutions) EXPECT_EQ(root.certified, true);
  for (const Solution& root : result.solutions) EXPECT_NEAR(std::abs(root.x[0] - 1.0), 1e-6, 1e-12);
}

}  // namespace
}  // namespace moivre::test
