// SPDX-License-Identifier: MIT
// Is every regular root certified and none that is not, and is a set of roots called complete by
// proof just where it is proved?
#include <gtest/gtest.h>

#include <regex>

#include "certificates.h"
#include "clusters.h"
#include "completeness.h"
#include "group_lists.h"
#include "judge.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "problem_set.h"

namespace moivre::test {
namespace {

std::uint64_t certified(const SolveResult& result) {
  return static_cast<std::uint64_t>(
      std::count_if(result.solutions.begin(), result.solutions.end(),
                    [](const Solution& s) { return s.certified == true; }));
}

void expect_proved(const SolveResult& result, const std::string& kind) {
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(certified(result), result.solutions.size());
  ASSERT_EQ(result.completeness, RootCompleteness::proved);
  EXPECT_EQ(name_in_results(result.bound->kind), kind);
  EXPECT_EQ(result.bound->value, result.solutions.size());
}

/// By the lanes, with each of the seeds first ... last.
std::vector<SolveResult> solved_by_lanes(const System& f, std::uint64_t first, std::uint64_t last) {
  const auto lanes = make_lane_tracker();
  std::vector<SolveResult> results;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    results.push_back(solve(f, *lanes, with_seed(seed)));
  }
  return results;
}

void expect_proved(const System& f, std::uint64_t first, std::uint64_t last, std::size_t roots,
                   const std::string& kind) {
  for (const SolveResult& result : solved_by_lanes(f, first, last)) {
    SCOPED_TRACE(result.seed);
    expect_proved(result, kind);
    EXPECT_EQ(result.solutions.size(), roots);
  }
}

TEST(Certified, CompletenessIsProvedWhereABoundIsMet) {
  const std::pair<const char*, const char*> expected[]{
      {"katsura-5", "total degree"},
      {"noon-3", "mixed volume"},
      {"eco-6", "mixed volume"},
      {"puma", "multihomogeneous number"},
      {"cyclic-5", "dimension of the quotient ring"},
      {"cassou", "dimension of the quotient ring"},
      {"seven-link-14", "dimension of the quotient ring"}};
  for (const auto& [name, kind] : expected) {
    SCOPED_TRACE(name);
    expect_proved(solve_with_cvode(system_of(problem(name))), kind);
  }
}

TEST(Certified, CoefficientsBeyondDoubleAreNoHindrance) {
  for (const char* factor : {"1", "1e400", "1e-4000"}) {
    const System f = read_system({"test", factor + std::string("*(x^2 + 3*x*y - 10) = 0\n") +
                                              "2e-900*x*y - 3e-900*y = 1e-901\n"});
    expect_proved(f, 1, 3, 3, "multihomogeneous number");
  }
}

TEST(Certified, ARootNextToZeroHasItsDigits) {
  const System f = read_system({"test", "(x - 1)*(x + 2)*(x - 1e-200);"});
  for (const SolveResult& result : solved_by_lanes(f, 1, 5)) {
    double least = 1;
    for (const Solution& root : result.solutions) least = std::min(least, std::abs(root.x[0]));
    EXPECT_NEAR(least / 1e-200, 1, 1e-15) << result.seed;
  }
}

TEST(Certified, ExactAlgebraProvesWhateverTheStart) {
  SolveOptions options = with_seed(2);
  options.start = StartKind::total_degree;
  expect_proved(solve_with_cvode(system_of(problem("eco-5")), options),
                "dimension of the quotient ring");
}

TEST(Certified, EliminationProvesWhatItDecides) {
  expect_proved(solve_with_cvode(read("2\n x + y - 3;\n x - y - 1;\n")), "elimination");
  expect_proved(solve_with_cvode(read("2\n x + y - 3;\n x + y - 1;\n")), "elimination");
}

TEST(Certified, AMultipleRootIsNotCertified) {
  const SolveResult result =
      solve_with_cvode(read("2\n x^2 - 2*x + 1 + y^2 - x*y - 3;\n y^2 - x*y - 3;\n"));
  expect_conservation(result);
  EXPECT_EQ(result.solutions.size(), 2U);
  EXPECT_EQ(certified(result), 0U);
  EXPECT_EQ(result.completeness, RootCompleteness::shown);
  EXPECT_FALSE(result.bound);
}

// The origin counts ten times, and a simple root lies 5e-8 beside it: eleven ends within an
// endgame's error of each other.
TEST(Certified, ASimpleRootBesideAMultipleOneIsNotTakenForAPartOfIt) {
  const System f = read(
      "3\n x^2*y - y^2*z - 7*y*z^2 + x*z + 5903*y*z;\n"
      " 6*x*y*z - x*z^2 - 8*y^3 - 3*y*z^2 + 6*x*y + 8*x*z - y^2;\n"
      " -6124*x^3 - 8*x*y^2 + 6*x*z^2 + 5261*z^3 + x*y - x*z;\n");
  for (const StartKind start : {StartKind::total_degree, StartKind::polyhedral}) {
    SolveOptions options = with_seed(1);
    options.start = start;
    const SolveResult result = solve_with_cvode(f, options);
    expect_conservation(result);
    for (const Solution& root : result.solutions) EXPECT_NE(root.multiplicity, 11U);
    if (result.complete) {
      EXPECT_EQ(result.solutions.size(), 18U);
    }
  }
}

// Five sheets of a cycle end at the origin, on a line of roots, and the sixth at a simple root 9e-8
// beside it. Their mean is no root.
TEST(Certified, ASimpleRootBesideASetIsNotTakenForAPartOfIt) {
  const System f = read(
      "4\n -4102*x^2*w - x*y*z - 6*x*y*w - 5*x*z^2 - 9*x*z*w + 7136*y^3 - 7778*y*w^2 + x*y + "
      "3174*y*z "
      "- y*w;\n"
      " 4*x*y*z + 9*y*z*w + 5*x*z - x*w - y*z + 2*y*w + 3217*w^2;\n"
      " 3*x^2*z + x*y*w + 3*y^2*w - 4300*y*z*w + x^2 + 89*x*y + y*z;\n"
      " 9082*x*y*w + z*w^2 - 5764*x^2 + 8034*x*y - 1558*x*w + 5029*z*w;\n");
  const auto lanes = make_lane_tracker();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SolveResult result = solve(f, *lanes, with_seed(seed));
    expect_conservation(result);
    EXPECT_TRUE(!result.complete || result.solutions.size() == 43U) << seed;
  }
}

// Three simple roots and the origin, which counts four times: 7 = mixed volume.
TEST(Certified, ExactMultiplicitiesCountTowardsABound) {
  const System f = read("2\n x^2 - 3*y^3;\n y^2 - x^2*y + x^4;\n");
  const SolveResult result = solve_with_cvode(f);
  expect_conservation(result);
  EXPECT_TRUE(result.complete);
  ASSERT_EQ(result.completeness, RootCompleteness::proved);
  EXPECT_EQ(result.bound->value, result.paths.finite);
}

// Coefficients of twelve digits: what was at infinity before they were rounded lies at 1e11 to
// 1e13.
TEST(Certified, EndsBeyondTheDigitsOfAFileAreToldAsSuch) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SolveResult result =
        solve(system_of(problem("ipp2")), *make_lane_tracker(), with_seed(seed));
    expect_conservation(result);
    EXPECT_TRUE(result.complete) << seed;
    EXPECT_GE(result.solutions.size(), 16U) << seed;
    EXPECT_TRUE(std::any_of(
        result.left_out.begin(), result.left_out.end(),
        [](const LeftOut& left) { return left.what == "what the file's digits do not tell"; }))
        << seed;
  }
}

// Eliminating z puts 2.00000000003 into nearly every coefficient. Its errors alone would hide that
// the four roots, of size 1e6, are finite; but they cancel in the square of (x z + 6).
TEST(Certified, RootsThatNoErrorOfTheFilesNumbersMovesToInfinityAreFinite) {
  const System f = read(
      "3\n x^2*z^2 + 12*x*z + 35.99999999992;\n 2*x - 9*z - 2.00000000003;\n"
      " -x^2*z + 7*x*y*z - 2*x*z^2 - 3*x^2 - 5*x*z - 8*x + 42*y - 12*z - 27.99999999994;\n");
  expect_proved(f, 1, 5, 4, "multihomogeneous number");
}

// (9 x^2 - 5 z + 4)^2 = 2e-12, known to 0.5e-12, keeps four roots from infinity. Their face
// vanishes exactly, whatever the digits are.
TEST(Certified, ARootOfAFaceIsAtInfinityOnlyWhereTheFilesNumbersMayMoveTheEndsThere) {
  const System f = read(
      "3\n 81*x^4 - 90*x^2*z + 72*x^2 + 25*z^2 - 40*z + 15.999999999998;\n"
      " -8*x*y - 6*y^2 + 5*y + 4.000000000008;\n"
      " -81*x^3 + 27*x^2*y + 81*x^2*z - 81*x^2 - 8*x*y + 45*x*z - 15*y*z - 45*z^2 - 36*x + 12*y"
      " + 81*z - 38.000000000002;\n");
  for (const SolveResult& result : solved_by_lanes(f, 1, 2)) {
    expect_conservation(result);
    EXPECT_TRUE(!result.complete || result.solutions.size() == 8U) << result.seed;
  }
}

// A^2 = 1e-10 and A L = -9 have roots of size 1e6, to which four sheets go that look as if they
// went to infinity, to 1e-11 of the squares of x_0. That is less than the file's relative error of
// 5e-11, but no number of the file changes these squares by as much. In double alone these ends are
// not known.
TEST(Certified, WhatIsLostInTheLargestErrorOfTheFileIsNotAtInfinity) {
  const System f = read(
      "3\n x^2*y^2 - 10*x*y^2*z + 25*y^2*z^2 + 6*x*y*z - 30*y*z^2 + 2*x*y - 10*y*z + 9*z^2 + 6*z + "
      "0.9999999999;\n"
      " 9*x^2*y - 9*x*y^2 - 49*x*y*z + 45*y^2*z + 20*y*z^2 + 2*x*y + 27*x*z - 37*y*z - 12*z^2 + 9*x"
      " - 9*y + 2*z + 11.0000000008;\n"
      " -40*x^2 - 30*x*y + 15*x*z + 10*y^2 + 15*y*z + 67*x - 23*y - 27*z + 9.0000000005;\n");
  SolveOptions options = with_seed(1);
  options.precision = Precision::double_precision;
  const SolveResult result = solve(f, *make_lane_tracker(), options);
  EXPECT_EQ(result.paths.at_infinity, 0U);
  EXPECT_FALSE(result.complete);
}

// (x - 4 z - 1)^3 = -1e-12, and y is 1e4 times larger the nearer x - 4 z is to 1. The digits of the
// file may make it 5e-13, not 0.
TEST(Certified, ARootOfAFaceNeedsErrorsInTheEquationsThatDoNotVanish) {
  const System f = read(
      "3\n x^3 - 12*x^2*z + 48*x*z^2 - 64*z^3 - 3*x^2 + 24*x*z - 48*z^2 + 3*x - 12*z - "
      "0.999999999999;\n"
      " 6*x^2 - 3*x*y - 18*x*z + 12*y*z - 24*z^2 - 7*x + 3*y - 5*z + 6.999999999996;\n"
      " -6*x*y + 5*z + 2.999999999997;\n");
  for (const SolveResult& result : solved_by_lanes(f, 1, 5)) {
    expect_conservation(result);
    EXPECT_TRUE(!result.complete || result.solutions.size() == 6U) << result.seed;
  }
}

// Some ends are beyond 1e11 at the first circle that tells anything, and turn out to be a root of
// size 4000 and infinity nearer to t = 1. Which bound the roots meet first depends on what is seen.
TEST(Certified, AnEndThatIsNotToldFromAfarIsLookedAtFromNearer) {
  const System f = read(
      "3\n -x^2*y*z - 8*x*y^2*z + x^2*y - 4466*x*y*z + 7*x^2 + x;\n"
      " x^2*y^2 + x*y^2 - 3595*y^2 - y;\n"
      " -8*x^2*z^2 + 8359*y*z^3 - 9*y*z^2 + x*z - z;\n");
  for (const SolveResult& result : solved_by_lanes(f, 1, 3)) {
    SCOPED_TRACE(result.seed);
    EXPECT_EQ(result.solutions.size(), 19U);
    ASSERT_EQ(result.completeness, RootCompleteness::proved);
    EXPECT_EQ(certified(result), 19U);
  }
}

// x + y = 3 and 3 +- 6e-8 i: 128 bits converge to each, and do not prove it.
TEST(Certified, ThreeRootsThatNewtonsMethodTellsApartAreProvedWithMoreDigits) {
  const System f = read(
      "3\n -x^5 - 5*x^4*y - 10*x^3*y^2 - 10*x^2*y^3 - 5*x*y^4 - y^5 + 7*x^4 + 28*x^3*y + 42*x^2*y^2"
      " + 28*x*y^3 + 7*y^4 - 9.9996000000000036*x^3 - 29.9988000000000108*x^2*y"
      " - 29.9988000000000108*x*y^2 - 9.9996000000000036*y^3 - 18.0035999999999964*x^2"
      " - 36.0071999999999928*x*y - 18.0035999999999964*y^2 + 27.01080000000001800144*x"
      " + 27.01080000000001800144*y + 26.98920000000001079568;\n"
      " -3*x^2 - 6*x*y - 2*y^2 - 4*y*z + 4*z^2 - 5*x - 5*y - 5;\n"
      " 5*x*z + y*z + 9*z^2 + 6*z + 3;\n");
  expect_proved(f, 1, 3, 20, "total degree");
}

// x - 2 y = 5 +- 9e-6 i: their mean is told as a double root known to 8e-9, and neither lies so
// near to it.
TEST(Certified, ARootThatNoPathHoldsRefutesADoubleOneHoweverWellThatSeemsKnown) {
  const System f = read(
      "2\n -21*x^6 + 252*x^5*y - 1260*x^4*y^2 + 3360*x^3*y^3 - 5040*x^2*y^4 + 4032*x*y^5 - 1344*y^6"
      " + 300*x^5 - 3000*x^4*y + 12000*x^3*y^2 - 24000*x^2*y^3 + 24000*x*y^4 - 9600*y^5"
      " - 1518.001701001701*x^4 + 12144.013608013608*x^3*y - 36432.040824040824*x^2*y^2"
      " + 48576.054432054432*x*y^3 - 24288.027216027216*y^4 + 3144.01749600729*x^3"
      " - 18864.10497604374*x^2*y + 37728.20995208748*x*y^2 - 25152.13996805832*y^3"
      " - 1905.046170007533137781*x^2 + 7620.184680030132551124*x*y"
      " - 7620.184680030132551124*y^2 - 1500.000000002915960634*x + 3000.000000005831921268*y"
      " + 1500.030375004860098415;\n"
      " 6*x^2 - 19*x*y + 15*y^2 + 8*x - 12*y + 2;\n");
  expect_proved(f, 10, 15, 12, "total degree");
}

// A pair 7e-7 of its size apart, whose mean has a residual of 3e-17. On circles of 1e-4 its sheets
// meet as far as double tells.
TEST(Certified, APairWhoseMeanLooksLikeARootIsTwoRoots) {
  const System f = read(
      "2\n 4*x^5 + 40*x^4*y + 160*x^3*y^2 + 320*x^2*y^3 + 320*x*y^4 + 128*y^5 - 7*x^4 - 56*x^3*y"
      " - 168*x^2*y^2 - 224*x*y^3 - 112*y^4 - 237.996399999936*x^3 - 1427.978399999616*x^2*y"
      " - 2855.956799999232*x*y^2 - 1903.971199999488*y^3 + 180.957700000656*x^2"
      " + 723.830800002624*x*y + 723.830800002624*y^2 + 3660.1188000017600576*x"
      " + 7320.2376000035201152*y + 900.0324000004000144;\n"
      " 6*x^2 + 17*x*y + 11*y^2 - 2*x - 2*y - 1;\n");
  expect_proved(f, 1, 5, 10, "total degree");
}

TEST(Certified, ADoubleRootAndNearlyOneAreToldApart) {
  const std::string y = "y^2 - x*y - 3;\n";
  const std::string ten16 = "10000000000000000";
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SolveResult pairs =
        solve_with_cvode(read("2\n x^2 - 2*x + 1 + 1/" + ten16 + ";\n" + y), with_seed(seed));
    expect_proved(pairs, "total degree");
    EXPECT_EQ(real_count(pairs), 0U);
    const SolveResult real =
        solve_with_cvode(read("2\n x^2 - 2*x + 1 - 1/" + ten16 + ";\n" + y), with_seed(seed));
    expect_proved(real, "total degree");
    EXPECT_EQ(real_count(real), 4U);
  }
}

TEST(Certified, ARootIsNotRealWhoseImaginaryPartIsProvedHoweverSmall) {
  const System f = read("1\n x^2 - 2*x + 1 + 1/10000000000000000;\n");
  Prover prover(make_certify_program(f));
  Root root;
  root.point.x = {Complex(1, 1e-8)};
  root.point.accuracy = 1e-7;
  EXPECT_TRUE(is_real(root));
  root.certificate = prover.prove(root.point.x);
  ASSERT_NE(root.certificate, nullptr);
  EXPECT_FALSE(is_real(root));
}

// Pairs 1e-14 and 1e-20 apart: double-double takes each for a double root.
TEST(Certified, RootsThatNoPathPartsArePartedByProof) {
  for (const char* e :
       {"1/10000000000000000000000000000", "1/10000000000000000000000000000000000000000"}) {
    const SolveResult result =
        solve_with_cvode(read(std::string("2\n (-3*x + 4*y + 1)^2 - ") + e +
                              "*(-2*x - 4*y + 2)^2;\n 3*x^2 - 2*x*y + 6*x - 3*y^2 - 6*y + 3;\n"));
    expect_conservation(result);
    expect_proved(result, "total degree");
    EXPECT_EQ(result.solutions.size(), 4U);
    EXPECT_EQ(real_count(result), 4U);
  }
}

TEST(Certified, NothingIsSaidWhereNothingIsAsked) {
  SolveOptions options = with_seed(1);
  options.certify = false;
  const SolveResult result = solve_with_cvode(system_of(problem("katsura-5")), options);
  EXPECT_TRUE(result.complete);
  EXPECT_FALSE(result.completeness);
  EXPECT_FALSE(result.bound);
  for (const Solution& s : result.solutions) EXPECT_FALSE(s.certified);
}

TEST(Certified, CombinationsProveNothingOfTheFilesEquations) {
  const SolveResult result =
      solve_with_cvode(read("3 2\n x^2 + y^2 - 5;\n x*y - 2;\n x^3 + y^3 - 9;\n"));
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.solutions.size(), 2U);
  EXPECT_FALSE(result.completeness);
  for (const Solution& s : result.solutions) EXPECT_FALSE(s.certified);
}

// Two of its eight roots are 8e12 away, in the direction of double roots at infinity: a random
// system that was told wrongly once.
TEST(Certified, ARootAsFarAsATrillionIsNotTakenForOneAtInfinity) {
  const System f = read(
      "3\n9*x1^2*x3^2+48*x1^2*x3+64*x1^2-54*x1*x3-144*x1+81.000000000009;\n"
      "27*x1^2*x3-9*x1*x2*x3-18*x1*x3^2+63*x1^2-24*x1*x2-51*x1*x3-3*x2*x3-89*x1+33*x2+54*x3"
      "+7.000000000007;\n"
      "21*x1^2*x3+3*x1*x2*x3-18*x1*x3^2+56*x1^2+8*x1*x2-42*x1*x3-54*x1-9*x2+49*x3"
      "-12.999999999994;\n");
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SolveOptions options;
    options.seed = seed;
    const SolveResult result = solve(f, *make_lane_tracker(), options);
    EXPECT_TRUE(!result.complete || result.solutions.size() == 8) << seed;
  }
}

// The line of roots x = 0 passes a simple root at 2e-8 of its size: nearer than an end on the line
// is known.
TEST(Certified, AnEndOnASetIsNotCountedToASimpleRootBesideIt) {
  const System f = read(
      "2\n -6980*x^3*y^2 - 5662*x;\n"
      " -x*y^4 - x^2*y^2 - 6060*x*y^3 + 8141*x*y^2 - 1823*x*y + 9*x;\n");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const SolveResult result = solve_with_cvode(f, with_seed(seed));
    expect_conservation(result);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.solutions.size(), 8U);
    for (const Solution& root : result.solutions) EXPECT_EQ(root.multiplicity, 1U);
  }
}

// Of its sixteen roots two are of size 1e31: in double-double they are regular ends whose x_0 is 0
// as far as any digit tells.
TEST(Certified, ARegularEndThatNoDigitPartsFromInfinityIsNotCalledInfinite) {
  const System f = read(
      "5\n 6*x*y - 200000*x - 900000000*y*z - 70000000*y*u + 600000000;\n"
      " -200000000*x - 500*y + 80000*z - 70*w - 6;\n"
      " -300000000*y - 60000*z^2 - 3000*z + 10000000*u^2 + 20;\n"
      " 20000*x + 600000*z*u - 3000000*u^2 + 5*u*w - 3000*u + 500;\n"
      " -800*x*w - 5000000*y*z - 300000*y*w + 90000*z^2 - 30000000*z*w - 80000*u - 30;\n");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    SolveOptions options = with_seed(seed);
    expect_proved(solve_with_cvode(f, options), "total degree");
    options.start = StartKind::total_degree;
    options.second_start = false;
    const SolveResult alone = solve_with_cvode(f, options);
    EXPECT_TRUE(!alone.complete || alone.solutions.size() == 16U);
  }
}

// Of its 62 roots one has coordinates of size 1e16 of which two sums are eliminated: one is -247,
// and 16 digits leave nothing of it.
TEST(Certified, ARootWhoseEliminatedUnknownsCancelIsFound) {
  const System f = read(
      "8\n -627*x1*x2-9*x1*x3-2877*x2*x3+x5*x7-900*x6*x7-7*x1+x2-5005*x3-2*x4+7830*x5-x8+8;\n"
      " -8*x1*x6+x2*x3+x3*x4-x3*x6+1200*x5*x6-x5*x8+1649*x1-x5+7*x7-x8-8;\n"
      " -6438*x1*x6-x1*x7+x1*x8+4*x6+x7+5383;\n"
      " -7705*x1*x6-9*x2*x4+9*x3*x4+4377*x3*x5+x3*x7+x4*x5+x2-713*x3+9*x4-5*x7+3234*x8-3810;\n"
      " 2*x1*x3+x1*x8-3826*x3^2+6*x3*x5+x4^2-x5*x7-2*x2-400*x4-3*x5-1;\n"
      " 7394*x1*x2+6*x3*x7-x5*x8+4488*x2-x3+8*x6+x7+3182;\n"
      " -x1+9*x2+6*x3-6*x4+x5+8*x6-6*x7+7*x8-9;\n"
      " -4*x1-x2-8*x3-4*x4+8*x5+6*x6+5*x7-6*x8-3;\n");
  expect_proved(f, 1, 2, 62, "dimension of the quotient ring");
}

// Of its 56 roots one has coordinates of size 1e11 whose roundings alone move the eliminated
// unknown, -6.15, by 3e-5.
TEST(Certified, ARootIsKnownByItsKeptUnknowns) {
  const System f = read(
      "7\n 8417*x2*x7+x3*x5+5*x3*x6-7*x4*x6+2562*x1-x6+1;\n"
      " x1*x2-x1*x5+x2*x5-5*x3*x6+x4*x5+x5^2-1965*x5*x6-2*x2-9540*x5-6808;\n"
      " -6*x1*x5+4*x2*x4+x2*x7+4*x3^2+6*x4*x7-4*x7+1;\n"
      " 4867*x2*x3+3317*x2*x6-9084*x3*x5+x5*x7+7301*x1+7*x4-7*x5-x6-2528*x7-1;\n"
      " -x1*x7-x2*x3-x2*x6+5*x2-9*x4-x7-3450;\n"
      " x2*x4+2372*x4-1774;\n"
      " -x1-x2-2*x3+5*x4+2*x5+9*x6+9*x7+5;\n");
  expect_proved(f, 1, 2, 56, "mixed volume");
}

// cyclic-5 by total degree: 70 roots and 50 paths to infinity.
TEST(Certified, PathsThatAreNotNeededEndAtNoOtherRootWhereTheyAreFollowed) {
  const System f = system_of(problem("cyclic-5"));
  SolveOptions options = with_seed(1);
  options.start = StartKind::total_degree;
  const SolveResult left = solve(f, *make_cvode_tracker(), options);
  options.every_path = true;
  const SolveResult followed = solve(f, *make_cvode_tracker(), options);
  EXPECT_GT(left.paths.not_needed, 0U);
  EXPECT_LT(followed.paths.not_needed, left.paths.not_needed);
  EXPECT_EQ(followed.paths.finite, left.paths.finite);
  EXPECT_EQ(followed.paths.at_infinity, left.paths.not_needed - followed.paths.not_needed);
  EXPECT_EQ(followed.completeness, RootCompleteness::proved);
}

TEST(Certified, WhatIsNotDecidedIsOpen) {
  CvodeOptions few;
  few.maximum_steps = 5;
  const SolveResult result =
      solve(read("2\n x^2 + y^2 - 5;\n x*y - 2;\n"), *make_cvode_tracker(few), with_seed(1));
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.completeness, RootCompleteness::open);
  EXPECT_FALSE(result.bound);
}

/// A run whose paths have their ends from outside.
class CertifiedEnds : public testing::Test {
 protected:
  void enter_root(std::uint64_t path, Complex x) {
    Prover prover(setting.certify_program);
    Refiner refiner(setting.refiner_program);
    Root root;
    root.certificate = prover.prove({x});
    ASSERT_NE(root.certificate, nullptr);
    root.point = refiner.take(*root.certificate);
    root.tolerance = 1e-13;
    run.table.enter_root(path, std::move(root));
  }
  void enter_failure(std::uint64_t path) { run.table.enter_failure({path, Failure::precision, 1}); }

  // Roots 1 and 1 + 1e-14.
  System f = read("1\n (x - 1)*(x - 1 - 1/100000000000000);\n");
  SolveOptions options = with_seed(1);
  std::atomic<bool> stop{false};
  std::unique_ptr<Tracker> tracker = make_cvode_tracker();
  Setting setting{f, *tracker, options, stop};
  moivre::Run run{setting};
};

// x = 0 is a line of roots, to which three of five paths lead; where on it, no end tells.
constexpr const char* kBesideALine =
    "2\n 1322*x^2*y + 7232*x*y^2 - 783*x^2 - x*y;\n -9213*x^2*y + 6*x*y^2 + x*y;\n";

TEST(Certified, TheStrataProveCompletenessBesideCurves) {
  const System f = read(kBesideALine);
  expect_proved(f, 1, 3, 2, "mixed volume of the strata");
  expect_proved(solve_with_cvode(f), "mixed volume of the strata");
}

// Both equations squared: each root four times, and two points all the same.
TEST(Certified, ABoundOfPointsIsNoneOfMultiplicities) {
  System f = read(kBesideALine);
  for (Polynomial& p : f.polynomials) p = p * p;
  for (const SolveResult& result : solved_by_lanes(f, 1, 3)) {
    ASSERT_EQ(result.completeness, RootCompleteness::proved);
    EXPECT_EQ(result.bound->value, 2U);
    ASSERT_EQ(result.solutions.size(), 2U);
    for (const Solution& root : result.solutions) EXPECT_EQ(root.multiplicity, 4U);
  }
}

TEST_F(CertifiedEnds, AMetBoundLeavesNothingInDoubt) {
  enter_root(0, 1);
  enter_root(1, 1 + 1e-14);
  enter_root(2, 1);  // jumped
  enter_failure(3);
  EXPECT_TRUE(settle_by_bound(run));
  EXPECT_EQ(run.table.count(PathVerdict::not_needed), 2U);
  EXPECT_EQ(run.table.roots().size(), 2U);
  EXPECT_TRUE(run.table.failures().empty());
}

TEST_F(CertifiedEnds, OneRootTwiceMeetsNoBoundOfTwo) {
  enter_root(0, 1);
  enter_root(1, 1);
  enter_failure(2);
  EXPECT_FALSE(settle_by_bound(run));
  EXPECT_EQ(run.table.count(PathVerdict::not_needed), 0U);
  EXPECT_EQ(run.table.failures().size(), 1U);
}

TEST_F(CertifiedEnds, RootsNearerThanTheirTolerancesAreTwoByProof) {
  enter_root(0, 1);
  enter_root(1, 1 + 1e-14);
  enter_root(2, 1);
  EXPECT_EQ(test::lists_of(run.table.groups()), (test::GroupLists{{0, 1, 2}}));
  EXPECT_EQ(test::lists_of(groups_of(run)), (test::GroupLists{{0, 2}, {1}}));
  EXPECT_EQ(proved_roots(run), 2U);
}

// Two paths tell of a double root between the two roots.
TEST_F(CertifiedEnds, ThatAreOneMultipleRootByMistakeArePutRight) {
  Root root;
  root.point.x = {1 + 5e-15};
  root.point.accuracy = 1e-9;
  root.winding = 2;
  root.tolerance = 1e-7;
  root.on_set = SetHere::none;
  run.table.enter_root(0, Root(root));
  run.table.enter_root(1, Root(root));
  part_clusters(run);
  EXPECT_EQ(proved_roots(run), 2U);
  EXPECT_EQ(groups_of(run).size(), 2U);
}

// A path too many: which of the three is at no root is not known.
TEST_F(CertifiedEnds, ThatAreMoreThanTheRootsHaveFailed) {
  Root root;
  root.point.x = {1 + 5e-15};
  root.point.accuracy = 1e-9;
  root.winding = 3;
  root.tolerance = 1e-7;
  root.on_set = SetHere::none;
  for (const std::uint64_t path : {0U, 1U, 2U}) run.table.enter_root(path, Root(root));
  part_clusters(run);
  const JudgedEnds judged = judge(run);
  EXPECT_TRUE(judged.roots.empty());
  EXPECT_EQ(judged.open.size(), 3U);
}

// Five forms of degree 2 that vanish on two lines through 0, both axes.
constexpr const char* kFormsOnTwoLines =
    "5\n592*x1*x4+x1*x5-x2*x5-2859*x3^2+8167*x3*x4+2*x3*x5;\n2*x1^2-645*x4*x5+4751*x5^2;\n"
    "x1*x3-x2^2-3*x2*x3+566*x3^2-x3*x5-3*x4^2+x4*x5;\n"
    "-9*x1*x2-2*x3^2+7*x3*x4+7444*x3*x5+x4*x5;\n"
    "4*x1*x2+x1*x3+7*x1*x4-4431*x2*x3-x2*x5+6156*x3*x4;\n";

TEST(Certified, FormsThatVanishOnAnAxisHaveNoIsolatedRoot) {
  for (const SolveResult& result : solved_by_lanes(read(kFormsOnTwoLines), 1, 3)) {
    EXPECT_TRUE(result.solutions.empty());
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
  }
}

// Moved, the lines are no axes. 28 of the 32 paths end at (1, ..., 1), in whole cycles, but its
// local ring has more than 28 dimensions: it is no isolated root, though random planes beside it
// miss the lines. The other paths end on these.
TEST(Certified, ARootWithMorePartsThanPathsIsNotIsolated) {
  const System f = read(std::regex_replace(kFormsOnTwoLines, std::regex("x([1-5])"), "(x$1 - 1)"));
  for (const SolveResult& result : solved_by_lanes(f, 1, 3)) {
    SCOPED_TRACE(result.seed);
    EXPECT_TRUE(result.complete);
    EXPECT_TRUE(result.solutions.empty());
    EXPECT_EQ(result.paths.on_positive_dimensional, 32U);
  }
}

// Order 2 on lines through (0, +-sqrt(3), 0): no fractions are these roots, so that only numerical
// ranks refute the six paths that end at one of them in whole cycles.
TEST(Certified, AnIrrationalRootOnACurveIsNotIsolated) {
  const System f = read(
      "3\n26*x2^4-82*x1*x2^2+44*x2^2*x3-111*x1^2-91*x1*x3-156*x2^2+28*x3^2+246*x1-132*x3+234;\n"
      "800*x2^6+504*x1*x2^4+124*x2^4*x3+704*x1^2*x2^2+976*x1*x2^2*x3-6300*x2^4-1040*x2^2*x3^2-"
      "220*x1^3-1496*x1^2*x3-2232*x1*x2^2-2305*x1*x3^2+408*x2^2*x3-126*x3^3-1122*x1^2-651*x1*x3+"
      "16200*x2^2+3246*x3^2+2160*x1-2340*x3-13500;\n"
      "-4*x2^4-143*x1*x2^2+4*x2^2*x3-107*x1^2-85*x1*x3+24*x2^2-28*x3^2+429*x1-12*x3-36;\n");
  for (const SolveResult& result : solved_by_lanes(f, 1, 3)) {
    SCOPED_TRACE(result.seed);
    for (const Solution& root : result.solutions) EXPECT_FALSE(root.singular);
  }
}

// Five forms of degree 2 in a^2 - 2, b - a, ..., e - a without a common zero but 0: 2^5 each at a =
// +-sqrt(2). The ring stands still behind 462 monomials only, too many to be looked at.
TEST(Certified, AnIrrationalRootOfHighMultiplicityIsToldAsBefore) {
  const System f = read(
      "5\n(a^2 - 2)^2 + (b - a)*(c - a);\n(b - a)^2 + (c - a)*(d - a);\n(c - a)^2 + (d - a)*(e - "
      "a);\n"
      "(d - a)^2 + (e - a)*(a^2 - 2);\n(e - a)^2 + (a^2 - 2)*(b - a);\n");
  for (const SolveResult& result : solved_by_lanes(f, 1, 2)) {
    SCOPED_TRACE(result.seed);
    EXPECT_TRUE(result.complete);
    ASSERT_EQ(result.solutions.size(), 2U);
    for (const Solution& root : result.solutions) EXPECT_EQ(root.multiplicity, 32U);
  }
}

}  // namespace
}  // namespace moivre::test
