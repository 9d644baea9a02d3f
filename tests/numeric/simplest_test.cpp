// SPDX-License-Identifier: MIT
// Is a fraction found again from its rounded value, and is none simpler within the error?
#include "moivre/numeric/simplest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace moivre {
namespace {

TEST(Simplest, FindsEveryFractionOfASmallDenominatorAgain) {
  for (std::int64_t q = 1; q <= 60; ++q) {
    for (std::int64_t p = -2 * q; p <= 2 * q; ++p) {
      const double rounded = static_cast<double>(p) / static_cast<double>(q);
      EXPECT_EQ(simplest(rounded, 1e-12), Rational(p, q)) << p << '/' << q;
    }
  }
}

// 22/7 and 355/113 are the best known fractions of pi.
TEST(Simplest, NamesPisFamousFractions) {
  EXPECT_EQ(simplest(std::numbers::pi, 2e-3), Rational(22, 7));
  EXPECT_EQ(simplest(std::numbers::pi, 3e-7), Rational(355, 113));
  EXPECT_EQ(simplest(-std::numbers::pi, 0.2), Rational(-3));
}

TEST(Simplest, HasNoFractionOfASmallerDenominatorWithinTheError) {
  for (const double error : {0.1, 1e-2, 1e-3}) {
    const double x = std::sqrt(2.0) + error;
    const Rational found = simplest(x, error);
    for (std::int64_t q = 1; static_cast<double>(q) < 1 / error; ++q) {
      const auto p = static_cast<std::int64_t>(std::llround(x * static_cast<double>(q)));
      const bool is_within = abs(Rational(p, q) - Rational(x)) <= Rational(error);
      if (!is_within) continue;
      EXPECT_EQ(found, Rational(p, q)) << error;
      break;
    }
  }
}

TEST(Simplest, IsTheNumberItselfWithoutAnError) {
  EXPECT_EQ(simplest(0.1, 0), Rational(0.1));
  EXPECT_EQ(simplest(1e-20, 1e-15), Rational(0));
}

TEST(Simplest, RefusesWhatIsNoNumber) {
  EXPECT_THROW(simplest(INFINITY, 1), std::invalid_argument);
  EXPECT_THROW(simplest(1, NAN), std::invalid_argument);
  EXPECT_THROW(simplest(1, -1), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
