// SPDX-License-Identifier: MIT
// Does Newton's method find the way back to a path known in closed form, and only from nearby?
#include "moivre/tracker/path_system.h"

#include <gtest/gtest.h>

#include "moivre/polynomial/read.h"

namespace moivre {
namespace {

/// x^2 = 1 becomes x^2 = 3 + 4i: x(t)^2 = 1 + (2 + 4i) t.
struct Scene {
  Homotopy homotopy{read_system({"f", "1\nx^2 - 3 - 4*i;\n"}), read_system({"g", "1\nx^2 - 1;\n"})};
  PathSystem path{homotopy};
};
Complex root_at(Complex t) { return std::sqrt(1.0 + Complex(2, 4) * t); }
Complex affine(const Point& x) { return x[0] / x[1]; }

TEST(PathSystem, RestoresAPerturbedPointWithoutDoubleDouble) {
  Scene scene;
  Point x{root_at(0.5) + Complex(0.01, 0.02), 1.0};
  const Correction correction = scene.path.correct(x, Complex(0.5), {}, true);
  EXPECT_TRUE(correction.converged);
  EXPECT_LT(std::abs(affine(x) - root_at(0.5)), 1e-9);
  EXPECT_EQ(scene.path.work().fine_values, 0u);
}

TEST(PathSystem, RefusesAFarPoint) {
  Scene scene;
  Point x{root_at(0.5) + 1.0, 1.0};
  EXPECT_FALSE(scene.path.correct(x, Complex(0.5), {}, true).converged);
}

TEST(PathSystem, RefusesADoubleRootThatItWouldReachInTheEnd) {
  const Homotopy homotopy(read_system({"f", "1\n(x - 1)^2;\n"}),
                          read_system({"g", "1\nx^2 - 1;\n"}));
  PathSystem path(homotopy);
  Point x{1.001, 1.0};
  const Correction correction = path.correct(x, Complex(1), {.maximum_iterations = 60}, true);
  EXPECT_FALSE(correction.converged);
  EXPECT_EQ(path.work().factorizations, 1u);
}

TEST(PathSystem, TakesTheTimeFromWhatIsLeftOfItWhereDoubleIsTooCoarse) {
  // x(t) = 1 + sqrt(1 - t): at 1 - t = 1e-12 a double's t would move x by 1e-11.
  constexpr double kRest = 1e-12;
  const Homotopy homotopy(read_system({"f", "1\n(x - 1)^2;\n"}),
                          read_system({"g", "1\n(x - 1)^2 - 1;\n"}));
  PathSystem path(homotopy);
  Point x{1 + std::sqrt(kRest), 1.0};
  const PathTime t(Complex(1 - kRest), Complex(kRest));
  EXPECT_TRUE(path.correct(x, t, {.tolerance = 1e-14}, true).converged);
  EXPECT_GT(path.work().fine_values, 0u);
  EXPECT_LT(std::abs(affine(x) - (1 + std::sqrt(kRest))), 1e-14);
}

TEST(PathSystem, TheTangentIsTheLimitOfDifferencesAlongThePath) {
  Scene scene;
  const Point x{root_at(0.5), 1.0};
  ASSERT_TRUE(scene.path.linearize(x, Complex(0.5)));
  Point dx(2);
  scene.path.tangent(1, dx);
  // d(x_0/x_1)/dt at x_1 = 1.
  const Complex slope = dx[0] - x[0] * dx[1];
  const double h = 1e-5;
  EXPECT_LT(std::abs(slope - (root_at(0.5 + h) - root_at(0.5 - h)) / (2 * h)), 1e-9);
  // The tangent stands on the point: x^H x' = 0.
  EXPECT_LT(std::abs(std::conj(x[0]) * dx[0] + std::conj(x[1]) * dx[1]), 1e-14);
}

}  // namespace
}  // namespace moivre
