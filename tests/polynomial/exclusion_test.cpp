// SPDX-License-Identifier: MIT
// Is it never proved that a root is not there which is, and nearly always that one is not which is
// not?
#include "moivre/polynomial/exclusion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "moivre/polynomial/read.h"

namespace moivre::test {
namespace {

System system_of(const std::string& text) { return read_system({"test", text}); }

TEST(Exclusion, EndsAtTheRoot) {
  const System f = system_of("2\nx^2 - 2;\ny^3 - 3;\n");
  const Point root{std::sqrt(2.0), std::cbrt(3.0)};
  for (double away = 1e-14; away < 0.1; away *= 10) {
    const Point x{root[0] + away, root[1] - away / 2};
    EXPECT_TRUE(has_no_root_within(f, x, away / 1.5)) << away;
    EXPECT_FALSE(has_no_root_within(f, x, away + 1e-15)) << away;
  }
  EXPECT_FALSE(has_no_root_within(f, root, 1e-15));
}

TEST(Exclusion, SeesThroughIllConditionedEquations) {
  // A root at (1, 1); the equations differ by 1e-8.
  const System f = system_of("2\nx + y - 2;\nx + 1.00000001*y - 2.00000001;\n");
  EXPECT_TRUE(has_no_root_within(f, {1 + 1e-5, 1 - 1e-5}, 0.9e-5));
  EXPECT_FALSE(has_no_root_within(f, {1 + 1e-5, 1 - 1e-5}, 1.1e-5));
}

TEST(Exclusion, TellsPointsBesideMultipleRoots) {
  const System f = system_of("2\n(x - 1)^4;\ny^2 - 2*x*y + x^2;\n");
  EXPECT_FALSE(has_no_root_within(f, {1.001, 1.001}, 0.0011, 8));
  EXPECT_TRUE(has_no_root_within(f, {1.01, 1.01}, 0.001, 8));
  EXPECT_TRUE(has_no_root_within(f, {1.0, 1.01}, 0.001, 8));
}

TEST(Exclusion, TakesAnyNumberOfEquations) {
  const System f = system_of("3 2\nx^2 - 1;\ny^2 - 1;\nx*y - 1;\n");
  EXPECT_TRUE(has_no_root_within(f, {1, -1}, 1e-3));
  EXPECT_FALSE(has_no_root_within(f, {1, 1}, 1e-3));
}

TEST(Exclusion, ProvesNothingOutOfDoublesRange) {
  const System f = system_of("1\nx^5 - 2;\n");
  EXPECT_FALSE(has_no_root_within(f, {1e300}, 1e300));
  EXPECT_FALSE(has_no_root_within(f, {1}, HUGE_VAL));
}

}  // namespace
}  // namespace moivre::test
