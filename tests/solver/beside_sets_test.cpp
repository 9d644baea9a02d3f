// SPDX-License-Identifier: MIT
// Are isolated roots told that lie beside a curve, and clusters that no exact count parts, or is it
// said that they are not?
#include <gtest/gtest.h>

#include <string>
#include <vector>

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

/// As many roots, or the result says that it is not complete.
void expect_roots_or_doubt(const System& f, std::size_t roots,
                           const std::vector<std::uint64_t>& seeds) {
  const auto lanes = make_lane_tracker();
  for (const std::uint64_t seed : seeds) {
    const SolveResult result = solve(f, *lanes, with_seed(seed));
    EXPECT_TRUE(!result.complete || result.solutions.size() == roots) << seed;
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

// Planes that meet the curve at a small angle know badly where it comes to.
TEST(RootBesideACurve, ThatIsIrrationalIsNotLostWhereTheCurveIsBent) {
  for (const char* d : {"3/100000", "4/100000"}) {
    SCOPED_TRACE(d);
    expect_roots(read(std::string("2\n(x*y-1)*(x^2-2)^2; (x*y-1)*(x*y-1-") + d + ");\n"), 2, 2);
  }
}

// Two sheets of the root and one of the curve close one circle, and their mean is neither's.
TEST(RootBesideACurve, WhoseSheetsMeetTheCurvesIsFoundOrSaidToBeInDoubt) {
  const System f = read("2\n((x^2-1)^2-y)*(x^2-2)^2; ((x^2-1)^2-y)*(y-1-1/100000);\n");
  expect_roots_or_doubt(f, 2, {1, 3});
  const SolveResult by_cvode = solve_with_cvode(f, with_seed(3));
  EXPECT_TRUE(!by_cvode.complete || by_cvode.solutions.size() == 2U);
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

// All paths seem to end where the curve crosses itself. Exact algebra counts one simple root, so
// all of them go on in more digits.
TEST(RootBesideACurve, ThatIsSimpleIsFoundBesideACrossingOfTheCurve) {
  const std::string node = "((x - 3)*(y - 2) + (x - 3)^3)";
  expect_roots(read("2\n" + node + "*(5*(x - 3) + 2*(y - 2) + " + fraction(9) + "); " + node +
                    "*(x - 3 + 3*(y - 2) - 3*" + fraction(9) + ");\n"),
               1, 1);
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

// (0, -10000) lies 1e-8 of its size beside an arm of the hyperbola. Circles around two branch
// points tell a mean that is no root.
TEST(RootBesideACurve, ThatGoesToInfinityIsFound) {
  const System f = read("2\n(x*y-1)*(2*x+y+10000); (x*y-1)*(x-y-10000)*(x-y-3);\n");
  expect_roots_or_doubt(f, 2, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
}

// The line passes at 8e-4 beside a root of multiplicity 5, along whose sheets F passes for 0.
TEST(RootBesideACurve, OfMultiplicityFiveIsFoundOrSaidToBeInDoubt) {
  const System f = read(
      "2\n"
      "256*x^4+1792*x^3*y+4704*x^2*y^2+5488*x*y^3+2401*y^4-56148/25*x^3-272027/25*x^2*y"
      "-462641/25*x*y^2-1109829/100*y^3+4232203/625*x^2+26700421/1250*x*y+187552947/10000*y^2"
      "-2181764801/250000*x-14232353607/1000000*y+529922401/125000;"
      "336*x^3+984*x^2*y+357*x*y^2-588*y^3-38421/25*x^2-225699/100*x*y+18921/25*y^2+52854/25*x"
      "+14397/25*y-19224/25;\n");
  expect_roots_or_doubt(f, 1, {1, 23});
}

// The planes that tell a surface from its neighbour are as many as it has dimensions.
TEST(RootBesideACurve, IsNoPointOfAComplexSurfaceBesideIt) {
  const System f = read(
      "3\n"
      "(0+(-27648)*i)*x1^3+(11520+(57600)*i)*x1^2*x3+(0+(9216)*i)*x1*x2^2+(-13056+(-65280)*i)*x1*"
      "x2*x3+(30240+(72576)*i)*x1*x3^2+(0+(2048)*i)*x2^3+(-5632+(-28160)*i)*x2^2*x3+(48960+("
      "117504)*i)*x2*x3^2+(-95904+(-142560)*i)*x3^3+(9216+(9216)*i)*x1^2+(17664+(-768)*i)*x1*x2+("
      "-77376+(4992)*i)*x1*x3+(4864+(-1280)*i)*x2^2+(-44800+(18944)*i)*x2*x3+(99144+(-56520)*i)*"
      "x3^2+(-2784+(-8448)*i)*x1+(-2368+(-3584)*i)*x2+(14032+(16496)*i)*x3+(-696+(1016)*i);"
      "(-2160+(-864)*i)*x1^2+(720+(288)*i)*x1*x2+(-3240+(-600)*i)*x1*x3+(480+(192)*i)*x2^2+(-1728+"
      "(-320)*i)*x2*x3+(1120+(-16)*i)*x3^2+(204+(-684)*i)*x1+(692+(-1092)*i)*x2+(-896+(2124)*i)*x3"
      "+(-596+(-540)*i);"
      "(-288+(-1152)*i)*x1^2+(384+(1536)*i)*x1*x2+(-1728+(-3648)*i)*x1*x3+(-128+(-512)*i)*x2^2+("
      "1152+(2432)*i)*x2*x3+(-2048+(-2752)*i)*x3^2+((8883/5)+((-5991/25))*i)*x1+((-5922/5)+(("
      "3994/25))*i)*x2+((72028/25)+((-4958/5))*i)*x3+((392/25)+((33821/50))*i);\n");
  expect_roots_or_doubt(f, 1, {1, 22, 24});
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

// y^2 (10^13 y - x) = 0 has (1, 0) twice and (1, 1e-13): told apart by what is exact, not by how
// near they are.
TEST(DoubleRoot, ThatIsKnownExactlyIsParted) {
  for (const char* power : {"13", "16"}) {
    SCOPED_TRACE(power);
    const System f = read(std::string("2\ny^2*(10^") + power + "*y - x); (x - 1)*(x - y - 2);\n");
    const auto lanes = make_lane_tracker();
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const SolveResult result = solve(f, *lanes, with_seed(seed));
      if (!result.complete) continue;
      EXPECT_EQ(result.solutions.size(), 4U) << seed;
      for (const Solution& root : result.solutions) EXPECT_LE(root.multiplicity, 2U);
    }
  }
}

}  // namespace
}  // namespace moivre::test
