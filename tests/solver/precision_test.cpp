// SPDX-License-Identifier: MIT
// Does a path climb to the precision that it needs, no other path with it, and does the result say so?
#include <gtest/gtest.h>

#include <set>

#include "problem_set.h"

namespace moivre {
namespace {

using test::problem;
using test::system_of;
using test::with_seed;

SolveResult solve_with(const System& f, Precision precision, std::uint64_t seed = 1) {
  SolveOptions options = with_seed(seed);
  options.precision = precision;
  return test::solve_with_cvode(f, options);
}

TEST(Precision, FindsEveryRootOfWilkinsonsPolynomialOfDegreeTwenty) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const SolveResult result =
        solve_with(system_of(problem("wilkinson-20")), Precision::automatic, seed);
    EXPECT_TRUE(result.complete);
    std::set<Complex, bool (*)(Complex, Complex)> roots(
        [](Complex a, Complex b) { return a.real() < b.real(); });
    for (const Solution& s : result.solutions) roots.insert(s.x[0]);
    ASSERT_EQ(roots.size(), 20U);
    double k = 0;
    for (const Complex root : roots) EXPECT_EQ(root, ++k);
    EXPECT_GT(result.paths.double_double, 0U);
    test::expect_conservation(result);
  }
}

TEST(Precision, TellsTheRungOfEveryRoot) {
  const SolveResult result = solve_with(system_of(problem("wilkinson-20")), Precision::automatic);
  std::map<Rung, std::uint64_t> roots;
  for (const Solution& s : result.solutions) ++roots[s.precision];
  EXPECT_EQ(roots[Rung::mixed], result.paths.mixed);
  EXPECT_EQ(roots[Rung::double_double], result.paths.double_double);
}

TEST(Precision, StaysDoubleWhereThatIsAskedForAndSaysWhatItLacks) {
  const SolveResult result =
      solve_with(system_of(problem("wilkinson-20")), Precision::double_precision);
  EXPECT_FALSE(result.complete);
  EXPECT_GT(result.paths.failed, 0U);
  EXPECT_EQ(result.paths.double_double, 0U);
}

TEST(Precision, NoPathNeedsDoubleDoubleInWellConditionedSystems) {
  for (const char* name : {"katsura-5", "noon-3", "cyclic-5", "multiplicity-4", "chandra-5"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(solve_with(system_of(problem(name)), Precision::automatic).paths.double_double, 0U);
  }
}

TEST(Precision, DoubleDoubleThroughoutGivesTheSameRoots) {
  for (const char* name : {"katsura-5", "noon-3", "multiplicity-4"}) {
    SCOPED_TRACE(name);
    const System f = system_of(problem(name));
    const SolveResult result = solve_with(f, Precision::double_double);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.tracker, "double-double");
    EXPECT_EQ(result.paths.double_double, result.paths.tracked);
    EXPECT_EQ(result.solutions.size(), solve_with(f, Precision::automatic).solutions.size());
    EXPECT_EQ(test::sum_of_multiplicities(result), problem(name).roots.with_multiplicity);
  }
}

TEST(Precision, EachRungHasAName) {
  EXPECT_EQ(to_string(Rung::double_precision), "double");
  EXPECT_EQ(to_string(Rung::mixed), "mixed");
  EXPECT_EQ(to_string(Rung::double_double), "double-double");
}

}  // namespace
}  // namespace moivre
