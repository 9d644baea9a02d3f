// SPDX-License-Identifier: MIT
// Is a polynomial of degree five the one through its own values, slopes and bends?
#include "moivre/numeric/quintic.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

double p(double x) { return 2 - x + x * x * x - 3 * x * x * x * x * x; }
double slope(double x) { return -1 + 3 * x * x - 15 * x * x * x * x; }
double bend(double x) { return 6 * x - 60 * x * x * x; }

TEST(Quintic, IsThePolynomialWhoseValuesSlopesAndBendsItHas) {
  constexpr double kLength = 1.25;
  for (const double x : {0.0, 0.3, 1.0, 1.25, 2.0}) {
    const auto w = quintic_weights(x, kLength);
    const double sum = w.a * p(0) + w.slope_a * slope(0) + w.bend_a * bend(0) + w.b * p(kLength) +
                       w.slope_b * slope(kLength) + w.bend_b * bend(kLength);
    EXPECT_NEAR(sum, p(x), 1e-13 * std::max(1.0, std::abs(p(x))));
  }
}

}  // namespace
}  // namespace moivre
