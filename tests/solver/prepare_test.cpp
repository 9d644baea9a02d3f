// SPDX-License-Identifier: MIT
// Do the coordinates of a path and those of the system as given lead to each other, through
// elimination and scaling?
#include "prepare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "moivre/polynomial/read.h"
#include "moivre/tracker/path_system.h"
#include "problem_set.h"

namespace moivre {
namespace {

constexpr double kRounding = 1e-14;

using test::read;

/// x - 3 z is eliminated; sizes 1e6 and 1e-6 are scaled away.
System badly_scaled() { return read("3\n x - 3*z;\n 1e-12*x^2 - 1;\n 1e12*y^2 + 1e-6*x - 3;\n"); }

double greatest_difference(const Point& a, const Point& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]) / std::abs(b[i]));
  }
  return largest;
}

Prepared prepared_from(const System& f, SolveOptions options = {}) {
  options.start = StartKind::total_degree;
  return prepare(f, options, std::atomic<bool>{false});
}

/// With z_0 = 1.
Point to_homogeneous(const Prepared& prepared, const Point& x) {
  Point z = kept_of(prepared.reduction, x);
  for (std::size_t j = 0; j < z.size(); ++j) {
    const int e = -prepared.scaling.variable_log2[j];
    z[j] = {std::ldexp(z[j].real(), e), std::ldexp(z[j].imag(), e)};
  }
  return prepared.plan->last().chart().homogeneous(z);
}

TEST(Prepare, MapsAPointOfTheSystemThereAndBack) {
  const Prepared prepared = prepared_from(badly_scaled());
  ASSERT_TRUE(prepared.plan);
  EXPECT_EQ(prepared.plan->last().equations(), 2U);
  const Point x{3e5, 1e5, Complex(1e-6, 2e-6)};
  const Point homogeneous = to_homogeneous(prepared, x);
  ASSERT_EQ(homogeneous.size(), 3U);
  EXPECT_LT(greatest_difference(to_original(prepared, homogeneous), x), kRounding);
}

TEST(Prepare, MapsEveryMultipleOfAHomogeneousPointToOnePoint) {
  const Prepared prepared = prepared_from(badly_scaled());
  const Point x{3e5, 1e5, Complex(1e-6, 2e-6)};
  Point homogeneous = to_homogeneous(prepared, x);
  for (Complex& xi : homogeneous) xi *= Complex(0.3, -0.7);
  EXPECT_LT(greatest_difference(to_original(prepared, homogeneous), x), kRounding);
}

TEST(Prepare, MakesTheRootsOfTheSystemRootsAtTheEndOfThePaths) {
  const Prepared prepared = prepared_from(badly_scaled());
  PathSystem path(prepared.plan->last());
  const double y = std::sqrt(2e-12);
  ASSERT_TRUE(path.linearize(to_homogeneous(prepared, {1e6, 1e6 / 3, y}), PathTime(1.0, 0.0)));
  EXPECT_LT(path.residual(), kRounding);
  ASSERT_TRUE(path.linearize(to_homogeneous(prepared, {1e6, 1e6 / 3, 2 * y}), PathTime(1.0, 0.0)));
  EXPECT_GT(path.residual(), 0.1);
}

TEST(Prepare, GivesUnknownsOfSizeOneToThePaths) {
  const Prepared prepared = prepared_from(badly_scaled());
  const double y = std::sqrt(2e-12);
  for (const Complex& z : to_homogeneous(prepared, {1e6, 1e6 / 3, y})) {
    EXPECT_GT(std::abs(z), 1e-2);
    EXPECT_LT(std::abs(z), 1e2);
  }
}

TEST(Prepare, SaysWhatItLeftOut) { EXPECT_GE(prepared_from(badly_scaled()).left_out.size(), 2U); }

TEST(Prepare, LeavesEverythingAsItIsWhereThatIsAskedFor) {
  SolveOptions options;
  options.eliminate = false;
  options.scale = false;
  const Prepared prepared = prepared_from(badly_scaled(), options);
  EXPECT_EQ(degrees(prepared.reduction.system), (std::vector<std::uint64_t>{1, 2, 2}));
  EXPECT_TRUE(prepared.left_out.empty());
  EXPECT_EQ(natural_sizes(prepared), (std::vector<double>{1, 1, 1}));
}

TEST(Prepare, HasNothingToTrackWhereEliminationDecides) {
  EXPECT_FALSE(prepared_from(read("2\n x + y - 3;\n x - y - 1;\n")).plan);
  EXPECT_FALSE(prepared_from(read("2\n x + y - 1;\n x + y - 2;\n")).plan);
  EXPECT_FALSE(prepared_from(System{}).plan);
}

}  // namespace
}  // namespace moivre
