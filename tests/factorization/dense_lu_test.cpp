// SPDX-License-Identifier: MIT
// Does elimination in double-double solve what double cannot, and say when there is nothing to
// solve?
#include "moivre/factorization/dense_lu.h"

#include <gtest/gtest.h>

#include "moivre/numeric/double_double.h"

namespace moivre {
namespace {

using Number = ComplexDoubleDouble;

/// H_ij = 1 / (i + j + 1), of condition 1e16 at n = 12.
void fill_hilbert(DenseLu<Number>& lu) {
  const std::size_t n = lu.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      lu.matrix()[i * n + j] = {DoubleDouble(1) / DoubleDouble(static_cast<double>(i + j + 1)), {}};
    }
  }
}

TEST(DenseLu, SolvesHilbertsSystemToManyDigits) {
  constexpr std::size_t kSize = 12;
  DenseLu<Number> lu(kSize);
  fill_hilbert(lu);
  // b = H (1, i, 1, i, ...).
  std::vector<Number> b(kSize);
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) {
      b[i] +=
          product(lu.matrix()[i * kSize + j], Number(j % 2 == 0 ? Complex(1, 0) : Complex(0, 1)));
    }
  }
  ASSERT_TRUE(lu.factor());
  lu.solve(b);
  for (std::size_t j = 0; j < kSize; ++j) {
    const Number wanted(j % 2 == 0 ? Complex(1, 0) : Complex(0, 1));
    EXPECT_LT(magnitude1(b[j] - wanted), 1e-12) << j;
  }
}

TEST(DenseLu, DoesNotMindTheSizeOfARow) {
  DenseLu<Number> lu(2);
  const double large = 1e100;
  lu.matrix()[0] = 1 * large;
  lu.matrix()[1] = 1e20 * large;
  lu.matrix()[2] = 1.0;
  lu.matrix()[3] = 1.0;
  ASSERT_TRUE(lu.factor());
  std::vector<Number> b{large, 2.0};
  lu.solve(b);
  // x + 1e20 y = 1, x + y = 2.
  EXPECT_NEAR(to_double(b[0].re), 2, 1e-15);
  EXPECT_NEAR(to_double(b[1].re), -1e-20, 1e-35);
}

TEST(DenseLu, TellsAMatrixThatIsSingular) {
  DenseLu<Number> lu(2);
  for (Number& entry : lu.matrix()) entry = 3.0;
  EXPECT_FALSE(lu.factor());
  for (Number& entry : lu.matrix()) entry = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(lu.factor());
}

}  // namespace
}  // namespace moivre
