// SPDX-License-Identifier: MIT
// Does plain double stop where its residuals are made of rounding, and not before?
#include "plain_newton.h"

#include <gtest/gtest.h>

#include <cmath>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

TEST(PlainNewton, ComesToTheLastDigitOfAWellConditionedRoot) {
  const PlainNewton newton(read_system({"test", "1\nx^2 - 2;\n"}));
  EXPECT_NEAR(newton.polish({1.4})[0].real(), std::sqrt(2.0), 4e-16);
}

TEST(PlainNewton, LosesDigitsOfAnIllConditionedRootThatWasExact) {
  // (x - 1)(x - 1.001)(x - 1.002)(x - 1.003): the residual at 1 is rounding of terms near 6, F' is
  // 6e-9.
  const PlainNewton newton(
      read_system({"test", "1\n(x - 1)*(x - 1.001)*(x - 1.002)*(x - 1.003);\n"}));
  const double error = std::abs(newton.polish({1.0})[0] - 1.0);
  EXPECT_GT(error, 1e-10);
  EXPECT_LT(error, 1e-5);
}

TEST(PlainNewton, StaysWhereTheJacobianIsSingular) {
  const PlainNewton newton(read_system({"test", "1\nx^2 + 1;\n"}));
  EXPECT_EQ(newton.polish({0.0})[0], Complex(0));
}

}  // namespace
}  // namespace moivre
