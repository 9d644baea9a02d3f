// SPDX-License-Identifier: MIT
// Is what a number of the file changes in the samples its derivative, as the closed form says?
#include "file_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

constexpr std::size_t kOfTurn = 16;
constexpr double kNumber = 1.234567891;
constexpr double kHalfUnit = 5e-10;

// z^2 = p = 1.234567891 t + (1 - t), (x_1, x_0) = (z, 1) / (a_1 z + a_0):  dx_0 = -x_0^2 a_1 t dp /
// (2 z).
TEST(FileErrors, ChangeTheSamplesAsTheDerivativeSays) {
  const System f = read_system({"test", "1\n x^2 - 1.234567891;\n"});
  Homotopy homotopy(f, read_system({"test", "1\n x^2 - 1;\n"}));
  homotopy.set_coefficient_errors(coefficient_errors(f));
  PathSystem path(homotopy);
  const Contour circle = Contour::spiral(0.1, Complex(0, 2 * std::numbers::pi));
  const Point patch{Complex(0.3, 0.7), Complex(0.9, -0.2)};
  std::vector<Point> samples;
  std::vector<Complex> expected;
  for (std::size_t s = 0; s < kOfTurn; ++s) {
    const PathTime t = circle.at(static_cast<double>(s + 1) / kOfTurn);
    const Complex z = std::sqrt(kNumber * t.t + t.rest);
    const Complex x0 = 1.0 / (patch[0] * z + patch[1]);
    samples.push_back({z * x0, x0});
    expected.push_back(-x0 * x0 * patch[0] * t.t * kHalfUnit / (2.0 * z));
  }
  const auto changes = changes_of_x0(path, nullptr, circle, kOfTurn, samples, patch);
  ASSERT_EQ(changes.size(), 1U);
  for (std::size_t s = 0; s < kOfTurn; ++s) {
    EXPECT_LT(std::abs(changes[0][s] - expected[s]), 1e-8 * std::abs(expected[s])) << s;
  }
}

TEST(FileErrors, OfExactNumbersChangeNothing) {
  const System f = read_system({"test", "1\n x^2 - 3/2;\n"});
  Homotopy homotopy(f, read_system({"test", "1\n x^2 - 1;\n"}));
  homotopy.set_coefficient_errors(coefficient_errors(f));
  PathSystem path(homotopy);
  EXPECT_TRUE(changes_of_x0(path, nullptr, Contour::spiral(0.1, 1), kOfTurn, {}, {}).empty());
}

}  // namespace
}  // namespace moivre
