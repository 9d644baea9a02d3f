// SPDX-License-Identifier: MIT
// Do text, CSV and PHCpack's list tell the same roots as the result holds?
#include "moivre/report/solve_report.h"

#include <gtest/gtest.h>

#include <limits>

#include "hand_made_result.h"
#include "moivre/polynomial/read.h"
#include "moivre/report/point_list.h"

namespace moivre::test {
namespace {

const std::vector<std::string> kNames = {"x", "alpha"};

System two_equations() { return read_system({"two.phc", "2\nx^2 + alpha;\nalpha^3 - x;\n"}); }

void expect_the_roots(const std::vector<Point>& points, const SolveResult& result) {
  ASSERT_EQ(points.size(), result.solutions.size());
  for (std::size_t k = 0; k < points.size(); ++k) EXPECT_EQ(points[k], result.solutions[k].x);
}

TEST(SolvePhc, IsReadBackToTheLastBit) {
  const SolveResult result = hand_made_result();
  expect_the_roots(read_points({"list", solve_phc(result, two_equations())}, kNames), result);
}

TEST(SolvePhc, BeginsWithTheSystemThatAReaderFinds) {
  const System f = two_equations();
  EXPECT_EQ(read_system({"list", solve_phc(hand_made_result(), f)}), f);
}

TEST(SolvePhc, HasPhcpacksHeadingsInTheirOrder) {
  const std::string text = solve_phc(hand_made_result(), two_equations());
  std::size_t at = 0;
  for (const char* heading : {"\nTHE SOLUTIONS :\n2 2\n=====", "\nsolution 1 :\nt :  1.0",
                              "\nm : 1\nthe solution for t :\n", "\n x     : ", "\n alpha : -2.5",
                              "\n== err :  1.000E-16 = rco :  8.000E-02 = res :  1.000E-17 ==\n",
                              "solution 2 :\n", "\nm : 2\n"}) {
    at = text.find(heading, at);
    ASSERT_NE(at, std::string::npos) << heading << " is missing in\n" << text;
  }
}

TEST(SolveCsv, IsReadBackToTheLastBit) {
  const SolveResult result = hand_made_result();
  expect_the_roots(read_points({"table", solve_csv(result)}, kNames), result);
}

TEST(SolveCsv, LeavesUnknownNumbersEmpty) {
  SolveResult result = hand_made_result();
  result.solutions[0].condition = std::numeric_limits<double>::infinity();
  EXPECT_EQ(
      solve_csv(result),
      "path,real,singular,multiplicity,residual,accuracy,condition,x.re,x.im,alpha.re,alpha.im\n"
      "1,1,0,1,1e-17,1e-16,,0.1,0,-2.5,0\n"
      "3,0,1,2,0,1e-08,1e+15,0.3333333333333333,1e-20,0.5,-0.25\n");
}

TEST(PathsCsv, HasALineForEachPathWhateverBecameOfIt) {
  SolveResult result;
  PathRecord finite;
  finite.verdict = PathVerdict::finite;
  finite.solution = 3;
  finite.steps = 84;
  finite.followed = 1;
  PathRecord on_set = finite;
  on_set.solution = PathRecord::kNoSolution;
  PathRecord failed;
  failed.verdict = PathVerdict::failed;
  failed.stage = 1;
  failed.precision = PathPrecision::double_double;
  failed.followed = 4;
  failed.handed_over = true;
  PathRecord left;
  left.verdict = PathVerdict::not_needed;
  result.ledger = {finite, on_set, failed, left};
  result.failures = {{2, Failure::precision, 1}};
  PathRecord by_count = finite;
  by_count.by_count = true;
  result.ledger.push_back(by_count);
  EXPECT_EQ(paths_csv(result),
            "path,stage,verdict,solution,reason,precision,followed,handed_over,steps,by_count\n"
            "0,0,finite,3,,double,1,0,84,0\n"
            "1,0,on a set,,,double,1,0,84,0\n"
            "2,1,failed,,precision,double-double,4,1,0,0\n"
            "3,0,not needed,,,double,0,0,0,0\n"
            "4,0,finite,3,,double,1,0,84,1\n");
}

TEST(SolveText, TellsHowManyPathsNobodySawAtTheirRoot) {
  SolveResult result = hand_made_result();
  result.paths.by_count = 1;
  const std::string text = solve_text(result, "two.phc");
  EXPECT_NE(text.find("2 failed, 1 of the finite by a count of the roots, not seen there;"),
            std::string::npos)
      << text;
}

const std::string kAccountOfTwo =
    "two.phc: 2 equations in 2 unknowns, degrees 2 3, total degree 6\n"
    "6 paths (total-degree, cvode, seed 7): 3 finite, 1 at infinity, 2 failed; 4 tracked again, 2 "
    "in double-double\n"
    "2 isolated roots: 1 real, 1 not real; 1 singular\n"
    "some paths failed\n"
    "\n"
    "real root, path 1, accuracy 1e-16, condition 12\n"
    "  x     =  0.1\n"
    "  alpha = -2.5\n";
const std::string kSecondOfTwo =
    "\nroot, path 3, multiplicity 2, singular, accuracy 1e-08, condition 1e+15\n";
const std::string kFailedAndLeftOutOfTwo =
    "\n"
    "Failed\n"
    "  path 2: step limit, at t = 0.5\n"
    "  path 5: jumped, at t = 1\n"
    "\n"
    "Left out\n"
    "  z eliminated: a linear equation gives it\n"
    "\n"
    "0.25 s on 2 threads\n";

TEST(SolveText, GivesTheAccountTheRealRootsTheFailuresAndWhatWasLeftOut) {
  EXPECT_EQ(solve_text(hand_made_result(), "two.phc"),
            kAccountOfTwo + "\n1 root is not real (--all lists it)\n" + kFailedAndLeftOutOfTwo);
}

TEST(SolveText, PrintsOnlyTheDigitsThatAreKnown) {
  EXPECT_EQ(solve_text(hand_made_result(), "two.phc", ListedRoots::all),
            kAccountOfTwo + kSecondOfTwo + "  x     =  0.33333333\n  alpha =  0.5 - 0.25 i\n" +
                kFailedAndLeftOutOfTwo);
}

TEST(SolveText, ShowsAFewPointsOfSetsAndCountsTheOthers) {
  SolveResult result = hand_made_result();
  Solution point = result.solutions[1];
  point.real = false;
  point.accuracy = 1e-3;
  result.on_sets.assign(5, point);
  const std::string text = solve_text(result, "two.phc");
  EXPECT_NE(text.find("\npoint of a set of positive dimension, 2 paths\n  x     =  0.333\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\n2 more points of such sets (--all lists them)\n"), std::string::npos);
}

TEST(SolveText, NamesThePlanesOnWhichEveryEquationIsZero) {
  SolveResult result = hand_made_result();
  result.planes = {{{0, 1}, 1}};
  const std::string text = solve_text(result, "two.phc");
  EXPECT_NE(text.find("\nevery equation is zero on the plane x = alpha = 0, of dimension 1\n"),
            std::string::npos)
      << text;
}

TEST(SolveText, PrintsAllTheDigitsThatWereAskedFor) {
  SolveResult result = hand_made_result();
  result.solutions[1].x_digits = {{"0.333333333333333333333", "0"},
                                  {"0.500000000000000000001", "-0.250000000000000000002"}};
  EXPECT_EQ(solve_text(result, "two.phc", ListedRoots::all),
            kAccountOfTwo + kSecondOfTwo +
                "  x     =  0.333333333333333333333\n"
                "  alpha =  0.500000000000000000001 - 0.250000000000000000002 i\n" +
                kFailedAndLeftOutOfTwo);
}

}  // namespace
}  // namespace moivre::test
