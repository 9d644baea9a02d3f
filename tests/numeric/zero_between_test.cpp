// SPDX-License-Identifier: MIT
// Is a sign change found to rounding, however the function gets there?
#include "moivre/numeric/zero_between.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace moivre {
namespace {

template <class Function>
double zero_of(const Function& f, double a, double b) {
  return zero_between(f, a, b, f(a), f(b));
}

TEST(ZeroBetween, IsFoundToRounding) {
  EXPECT_NEAR(zero_of([](double x) { return std::cos(x); }, 0, 3), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(zero_of([](double x) { return x * x * x; }, -1, 2), 0, 1e-15);
}

TEST(ZeroBetween, IsTheStepOfAFunctionThatHasOnlySigns) {
  EXPECT_NEAR(zero_of([](double x) { return x < 0.3 ? 1.0 : -1.0; }, 0, 1), 0.3, 1e-15);
}

TEST(ZeroBetween, IsTheNearerEndWhereSignsAgree) {
  const auto f = [](double x) { return 1 + x * x; };
  EXPECT_EQ(zero_of(f, -1, 0.5), 0.5);
}

TEST(ZeroBetween, IsTheNearerEndWhereSignsAgreeThoughTheirProductIsZero) {
  const auto f = [](double x) { return 1e-200 * (1 + x * x); };
  EXPECT_EQ(zero_of(f, -1, 0.5), 0.5);
}

TEST(ZeroBetween, IsAnEndWhereThereIsNothingBetween) {
  const auto f = [](double x) { return x - 0.25; };
  EXPECT_EQ(zero_of(f, 1, 1), 1);
  EXPECT_EQ(zero_of(f, 1, 0), 0);
  EXPECT_EQ(zero_between(f, 0, 1, std::nan(""), 0.75), 1);
  EXPECT_EQ(zero_between(f, 0, 1, -0.25, std::nan("")), 0);
}

}  // namespace
}  // namespace moivre
