// SPDX-License-Identifier: MIT
// Do parabola, spline and typed law give value and two derivatives?
#include "moivre/mechanism/driver_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "files.h"

namespace moivre {
namespace {

TEST(DriverLaw, ParabolaHasItsDerivatives) {
  const DriverState state = driver_state(Parabola{1, 2, 3}, 2);
  EXPECT_DOUBLE_EQ(state.value, 1 + 4 + 6);
  EXPECT_DOUBLE_EQ(state.velocity, 8);
  EXPECT_DOUBLE_EQ(state.acceleration, 3);
}

TEST(DriverLaw, SplineGoesThroughItsPointsSmoothly) {
  const std::vector<double> t{0, 0.5, 1.5, 2, 4};
  const std::vector<double> value{1, -1, 2, 0, 3};
  const DriverLaw law = natural_spline(t, value);
  constexpr double kBeside = 1e-9;
  for (std::size_t k = 0; k < t.size(); ++k) {
    EXPECT_NEAR(driver_state(law, t[k]).value, value[k], 1e-14);
    const DriverState left = driver_state(law, t[k] - kBeside);
    const DriverState right = driver_state(law, t[k] + kBeside);
    EXPECT_NEAR(left.velocity, right.velocity, 1e-6);
    EXPECT_NEAR(left.acceleration, right.acceleration, 1e-6);
  }
}

TEST(DriverLaw, PeriodicSplineGoesOnSmoothlyFromOnePeriodToTheNext) {
  const std::vector<double> t{-1, 0, 1.5, 2, 4};
  const std::vector<double> value{1, -1, 2, 0, 1};
  const Spline spline = periodic_spline(t, value);
  constexpr double kBeside = 1e-9, kPeriod = 5;
  for (std::size_t k = 0; k < t.size(); ++k) {
    for (const double periods : {-2.0, 0.0, 3.0}) {
      const double at = t[k] + periods * kPeriod;
      EXPECT_NEAR(periodic_state(spline, at).value, value[k], 1e-13);
      const DriverState left = periodic_state(spline, at - kBeside);
      const DriverState right = periodic_state(spline, at + kBeside);
      EXPECT_NEAR(left.velocity, right.velocity, 1e-6);
      EXPECT_NEAR(left.acceleration, right.acceleration, 1e-6);
    }
  }
  EXPECT_THROW(periodic_spline({0, 1, 2}, {1, 2, 1}), std::invalid_argument);
}

TEST(DriverLaw, SplineDerivativesMatchDifferencesInsideAndOutside) {
  const DriverLaw law = natural_spline({0, 1, 3, 4}, {0, 2, 1, 5});
  constexpr double kStep = 1e-5;
  for (const double t : {-2.0, 0.3, 1.7, 3.9, 6.0}) {
    const DriverState here = driver_state(law, t);
    const DriverState next = driver_state(law, t + kStep);
    const DriverState back = driver_state(law, t - kStep);
    EXPECT_NEAR(here.velocity, (next.value - back.value) / (2 * kStep), 1e-8) << t;
    EXPECT_NEAR(here.acceleration, (next.velocity - back.velocity) / (2 * kStep), 1e-8) << t;
  }
}

TEST(DriverLaw, SplineThroughALineIsTheLine) {
  const DriverLaw law = natural_spline({0, 1, 5}, {1, 3, 11});
  const DriverState state = driver_state(law, 2.2);
  EXPECT_NEAR(state.value, 5.4, 1e-14);
  EXPECT_NEAR(state.velocity, 2, 1e-14);
  EXPECT_NEAR(state.acceleration, 0, 1e-14);
}

TEST(DriverLaw, SplineRefusesTimesThatDoNotIncrease) {
  EXPECT_THROW(natural_spline({0, 0}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(natural_spline({0}, {1}), std::invalid_argument);
}

TEST(DriverLaw, TypedLawIsDifferentiatedAndInTheFilesUnit) {
  const Mechanism m = test::typed(R"toml(
[units]
angle = "deg"
[unknowns]
angles = ["phi"]
lengths = ["x"]
[equations]
e = "x - cos(phi)"
[[driver]]
unknown = "phi"
value = "30 + 10*sin(2*t)"
)toml");
  const DriverState state = driver_state(m.drivers[0].law, 0.4);
  EXPECT_NEAR(state.value, (30 + 10 * std::sin(0.8)) * test::kDegree, 1e-15);
  EXPECT_NEAR(state.velocity, 20 * std::cos(0.8) * test::kDegree, 1e-15);
  EXPECT_NEAR(state.acceleration, -40 * std::sin(0.8) * test::kDegree, 1e-15);
}

}  // namespace
}  // namespace moivre
