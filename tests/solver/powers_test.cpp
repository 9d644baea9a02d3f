// SPDX-License-Identifier: MIT
// Equations that are powers: roots, multiplicities and counts are those of the system as given,
// whatever was followed.
#include <gtest/gtest.h>

#include "moivre/solver/trace.h"
#include "problem_set.h"
#include "sheets.h"

namespace moivre::test {
namespace {

TEST(Powers, CountTheirPathsAndRootsAsOftenAsTheyAre) {
  const SolveResult result = solve_with_cvode(read("2\n (x^2 - 2)^3;\n (x*y - 1)^2;\n"));
  expect_conservation(result);
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.start.paths, result.paths.tracked);
  EXPECT_EQ(result.paths.finite, 12U);
  ASSERT_EQ(result.solutions.size(), 2U);
  for (const Solution& root : result.solutions) {
    EXPECT_EQ(root.multiplicity, 6U);
    EXPECT_EQ(root.winding, std::vector<int>(6, 1));
    EXPECT_TRUE(root.singular);
    EXPECT_TRUE(root.real);
    EXPECT_EQ(root.path % 6, 0U);
    EXPECT_LT(std::abs(root.x[0] * root.x[1] - 1.0), 1e-14);
    EXPECT_LT(root.residual, 1e-30);
  }
  EXPECT_EQ(result.ledger.size(), result.paths.tracked);
  EXPECT_EQ(result.system.degrees, (std::vector<std::uint64_t>{6, 4}));
}

TEST(Powers, OfDegreeAHundredAreOneRoot) {
  const SolveResult result = solve_with_cvode(read("1\n (x + 1)^100;\n"));
  expect_conservation(result);
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_EQ(result.solutions[0].multiplicity, 100U);
  EXPECT_EQ(result.solutions[0].x[0], Complex(-1));
}

TEST(Powers, MultiplyTheMultiplicitiesOfTheirBases) {
  // x has multiplicity 2 at 0 on the parabola y = x^2 and the line y = 0.
  const SolveResult result = solve_with_cvode(read("2\n (y - x^2)^3;\n y^2;\n"));
  expect_conservation(result);
  ASSERT_EQ(result.solutions.size(), 1U);
  EXPECT_EQ(result.solutions[0].multiplicity, 12U);
}

TEST(Powers, HaveThePathsThatTrackFollows) {
  const auto cvode = make_cvode_tracker();
  const System f = read("2\n (x^2 - 2)^3;\n x*y^2 - y - 1;\n");
  const std::atomic<bool> never{false};
  const SolveResult result = solve(f, *cvode);
  for (const Solution& root : result.solutions) {
    for (const std::uint64_t path : {root.path, root.path + 2}) {
      const Trace trace = trace_path(f, *cvode, {}, path, never);
      EXPECT_EQ(trace.path, path);
      EXPECT_EQ(trace.paths, result.paths.tracked);
      ASSERT_EQ(trace.x.size(), 2U);
      EXPECT_LT(std::abs(trace.x[0] - root.x[0]) + std::abs(trace.x[1] - root.x[1]), 1e-9);
    }
  }
  EXPECT_THROW(trace_path(f, *cvode, {}, result.paths.tracked, never), std::invalid_argument);
}

TEST(Powers, ListEachFailedPathAndLeaveOutListsThatWouldBeTooLong) {
  const System f = read("1\n (x - 1)^3;\n");
  const PowerFree bases = power_free(f);
  SolveResult result;
  result.paths.tracked = result.paths.failed = 2;
  result.failures = {{0, Failure::precision, 1, 0}, {1, Failure::precision, 1, 0}};
  result.ledger.resize(2);
  take_back_powers(f, bases, result);
  ASSERT_EQ(result.failures.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(result.failures[k].path, k);
  PowerFree many = bases;
  many.sheets = kMostListed;
  take_back_powers(f, many, result);
  EXPECT_TRUE(result.failures.empty());
  EXPECT_TRUE(result.ledger.empty());
  EXPECT_EQ(result.paths.failed, 6 * kMostListed);
  many.sheets = std::uint64_t{1} << 40;
  EXPECT_THROW(take_back_powers(f, many, result), std::overflow_error);
}

}  // namespace
}  // namespace moivre::test
