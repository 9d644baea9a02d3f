// SPDX-License-Identifier: MIT
// Does the comparison of two runs find what was lost, and the path that was exchanged?
#include "moivre/solver/cross_check.h"

#include <gtest/gtest.h>

#include "problem_set.h"

namespace moivre {
namespace {

using test::problem;
using test::solve_with_cvode;
using test::system_of;

TEST(CrossCheck, OfARunWithItselfFindsNoDifference) {
  const SolveResult result = solve_with_cvode(system_of(problem("katsura-5")));
  const CrossCheck check = compare(result, result);
  EXPECT_EQ(check.common, result.solutions.size());
  EXPECT_EQ(check.missed, 0U);
  EXPECT_EQ(check.unwitnessed, 0U);
  EXPECT_TRUE(check.disagreements.empty());
}

TEST(CrossCheck, NamesThePathOfARootThatOneRunLost) {
  const SolveResult whole = solve_with_cvode(system_of(problem("katsura-5")));
  SolveResult lossy = whole;
  lossy.solutions.erase(lossy.solutions.begin() + 3);
  const std::uint64_t path = whole.solutions[3].path;
  const CrossCheck missed = compare(lossy, whole);
  ASSERT_EQ(missed.disagreements.size(), 1U);
  EXPECT_EQ(missed.missed, 1U);
  EXPECT_EQ(missed.disagreements[0].path, path);
  EXPECT_FALSE(missed.disagreements[0].found);
  EXPECT_EQ(missed.disagreements[0].witnessed, whole.solutions[3].x);
  EXPECT_EQ(compare(whole, lossy).unwitnessed, 1U);
}

TEST(CrossCheck, SeesTwoPathsExchangedThoughTheRootsAreTheSame) {
  const SolveResult result = solve_with_cvode(system_of(problem("katsura-5")));
  SolveResult exchanged = result;
  std::swap(exchanged.solutions[1].path, exchanged.solutions[2].path);
  const CrossCheck check = compare(result, exchanged);
  EXPECT_EQ(check.common, result.solutions.size());
  EXPECT_EQ(check.disagreements.size(), 2U);
}

TEST(CrossCheck, SettlesWhichTrackerLeftThePath) {
  const System f = system_of(problem("katsura-5"));
  const auto tracker = make_cvode_tracker();
  SolveResult jumped = solve_with_cvode(f);
  std::swap(jumped.solutions[1].path, jumped.solutions[2].path);
  cross_check(f, jumped, *tracker, *tracker, test::with_seed(1));
  ASSERT_TRUE(jumped.cross_check);
  ASSERT_EQ(jumped.cross_check->disagreements.size(), 2U);
  for (const Disagreement& difference : jumped.cross_check->disagreements) {
    EXPECT_EQ(difference.jumped, tracker->kind());
  }
  EXPECT_TRUE(jumped.complete);
}

TEST(CrossCheck, ARootThatOnlyTheWitnessFoundMakesTheResultIncomplete) {
  const System f = system_of(problem("katsura-5"));
  const auto tracker = make_cvode_tracker();
  SolveResult lossy = solve_with_cvode(f);
  lossy.solutions.pop_back();
  cross_check(f, lossy, *tracker, *tracker, test::with_seed(1));
  EXPECT_FALSE(lossy.complete);
  EXPECT_EQ(lossy.cross_check->missed, 1U);
}

// Three conics of one pencil: the paths are those of two combinations, which no trace follows.
TEST(CrossCheck, OfMoreEquationsThanUnknownsTellsTheDifferenceAndSettlesNone) {
  const System f = test::read("3 2\n x^2 + y^2 - 5;\n x*y - 2;\n x^2 + y^2 + x*y - 7;\n");
  const auto tracker = make_cvode_tracker();
  SolveResult lossy = solve_with_cvode(f);
  ASSERT_EQ(lossy.solutions.size(), 4U);
  lossy.solutions.pop_back();
  cross_check(f, lossy, *tracker, *tracker, test::with_seed(1));
  EXPECT_FALSE(lossy.complete);
  ASSERT_EQ(lossy.cross_check->disagreements.size(), 1U);
  EXPECT_FALSE(lossy.cross_check->disagreements[0].jumped);
}

}  // namespace
}  // namespace moivre
