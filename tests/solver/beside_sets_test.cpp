// SPDX-License-Identifier: MIT
// Are isolated roots told that lie beside a curve, and clusters that no exact count parts, or is it said that they are not?
#include <gtest/gtest.h>

#include <string>

#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre::test {
namespace {

/// The result that is due, with a few seeds: `roots` different ones, all of this multiplicity.
void expect_roots(const System& f, std::size_t roots, std::uint64_t multiplicity) {
  const auto lanes = make_lane_tracker();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const SolveResult result = solve(f, *lanes, with_seed(seed));
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.solutions.size(), roots);
    for (const Solution& root : result.solutions) EXPECT_EQ(root.multiplicity, multiplicity);
  }
}

std::string fraction(int power) {
  return "1/1" + std::string(static_cast<std::size_t>(power), '0');
}

TEST(RootBesideACurve, OfMultiplicityTwoIsNoPointOfIt) {
  for (const int power : {1, 2, 3, 4, 5}) {
    SCOPED_TRACE(power);
    expect_roots(read("2\n(x-1)^2*(2*x+3*y-7); (2*x+3*y-7+" + fraction(power) + ")*(2*x+3*y-7);\n"),
                 1, 2);
  }
}

TEST(RootBesideACurve, ThatIsIrrationalIsNoPointOfIt) {
  for (const int power : {2, 3}) {
    SCOPED_TRACE(power);
    expect_roots(
        read("2\n(x^2-2)^2*(2*x+3*y-7); (2*x+3*y-7+" + fraction(power) + ")*(2*x+3*y-7);\n"), 2, 2);
  }
}

System simple_beside_a_line(int power) {
  return read("2\n(x-y)*(x-1); (x-y)*(y-1-" + fraction(power) + ");\n");
}

// As near as 1e-12 of its size: in double its sheet and one of the line's are a double one.
TEST(RootBesideACurve, ThatIsSimpleIsFoundInMoreDigits) {
  for (const int power : {5, 6, 9, 10, 12}) {
    SCOPED_TRACE(power);
    expect_roots(simple_beside_a_line(power), 1, 1);
  }
}

// Where double nearly tells the two.
TEST(RootBesideACurve, ThatIsSimpleIsFoundOrSaidToBeInDoubt) {
  const auto lanes = make_lane_tracker();
  for (const int power : {7, 8, 13}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const SolveResult result = solve(simple_beside_a_line(power), *lanes, with_seed(seed));
      EXPECT_TRUE(!result.complete || result.solutions.size() == 1U) << power << ", seed " << seed;
    }
  }
}

// On a surface the points that moved planes meet depend on where one starts.
TEST(RootBesideACurve, IsNoPointOfASurfaceBesideIt) {
  expect_roots(
      read("3\n"
           "(-324)*x1^3+(-495)*x1^2*x2+(-315)*x1^2*x3+(-112)*x1*x2^2+(-478)*x1*x2*x3+(-58)*x1*x3^2"
           "+64*x2^3+(-176)*x2^2*x3+(-47)*x2*x3^2+(-3)*x3^3+(-18)*x1^2+(-196)*x1*x2+88*x1*x3+(-160"
           ")*x2^2+60*x2*x3+10*x3^2+56*x1+68*x2+(-4)*x3+(-8);"
           "12*x1^2+(-27)*x1*x2+(-23)*x1*x3+6*x2^2+(-10)*x2*x3+(-24)*x3^2+42*x1+(-21)*x2+11*x3+18;"
           "16*x1^2+(-8)*x1*x2+24*x1*x3+1*x2^2+(-6)*x2*x3+9*x3^2+(398/25)*x1+(-199/50)*x2+(597/50)"
           "*x3+(99/25);"),
      1, 2);
}

// (-1, 0), 3.5e-10 from a line, and a coordinate that is 0.
TEST(RootBesideACurve, WithACoordinateThatIsZeroIsFoundInMoreDigits) {
  expect_roots(
      read("2\n-136*x^3+242*x^2*y-124*x*y^2+18*y^3-(27624999997/62500000)*x^2+(26799999997/"
           "50000000)*x*y-(35499999997/250000000)*y^2-(118999999973/250000000)*x+(36749999991/"
           "125000000)*y-8499999997/50000000;\n"
           "136*x^2-55*x*y-9*y^2+(16999999997/62500000)*x-(27500000003/500000000)*y+8499999997/"
           "62500000;\n"),
      2, 1);
}

// Where a line makes the ring infinite no count tells that a double root is two.
TEST(ClusterBesideACurve, IsPartedInMoreDigits) {
  for (const int power : {20, 30, 40}) {
    SCOPED_TRACE(power);
    expect_roots(read("2\n((x-1)^2-" + fraction(power) + ")*(x+2*y-4); (4*x-y-2)*(x+2*y-4);\n"), 2,
                 1);
  }
}

TEST(ClusterBesideACurve, NearerThanDoublesDigitsIsPartedOrSaidToBeInDoubt) {
  const auto lanes = make_lane_tracker();
  const System f = read("2\n((x-1)^2-" + fraction(60) + ")*(x+2*y-4); (4*x-y-2)*(x+2*y-4);\n");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SolveResult result = solve(f, *lanes, with_seed(seed));
    EXPECT_TRUE(!result.complete || result.solutions.size() == 2U);
  }
}

TEST(RootOfCombinations, ThatFailsAnEquationIsRefutedByExactNumbers) {
  const auto lanes = make_lane_tracker();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SolveResult result =
        solve(read("3 2\n(x-1)*(y-2); (x-1)*(y-2-1/3000000); (x-1)*(x-5)+y-2;\n"), *lanes,
              with_seed(seed));
    EXPECT_EQ(result.solutions.size(), 1U);
  }
}

}  // namespace
}  // namespace moivre::test
