// SPDX-License-Identifier: MIT
// Does a mechanism know as much of itself in micrometres as in kilometres?
#include "moivre/kinematics/own_units.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../mechanism/files.h"
#include "../mechanism/in_unit.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/kinematics/state.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

constexpr const char* kNames[] = {"four-bar",     "jansen-leg", "double-parallel-crank",
                                  "slider-crank", "whitworth",  "rssr",
                                  "bennett"};
/// Largest lengths from 1e-9 to 1e9 are taken.
constexpr double kUnits[] = {1e-10, 1e-5, 1, 1e4, 3e6};

VectorXd in_unit(const Phi& phi, VectorXd q, double unit) {
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    if (phi.coordinates()[static_cast<std::size_t>(k)].kind == CoordinateKind::length) q[k] *= unit;
  }
  return q;
}

class EveryUnit : public testing::TestWithParam<const char*> {};

TEST_P(EveryUnit, LeavesRankAndFreedomsAndNewtonsWayAsTheyAre) {
  const Mechanism mechanism = test::example(GetParam());
  const Phi phi(mechanism);
  const NewtonResult assembled = newton(phi, initial_guess(mechanism));
  ASSERT_EQ(assembled.status, NewtonStatus::converged) << assembled.message;
  const Mobility known = mobility(phi, assembled.q, 0);
  const MotionState moving = motion_state(phi, assembled.q, 0);
  for (const double unit : kUnits) {
    SCOPED_TRACE(unit);
    const Mechanism same = test::in_unit(mechanism, unit);
    const Phi scaled(same);
    const VectorXd guess = in_unit(phi, initial_guess(mechanism), unit);
    const NewtonResult found = newton(scaled, guess);
    EXPECT_EQ(found.status, NewtonStatus::converged) << found.message;
    EXPECT_EQ(found.steps(), assembled.steps());
    EXPECT_EQ(found.is_singular, assembled.is_singular);
    const VectorXd q = in_unit(phi, assembled.q, unit);
    EXPECT_LE(largest_of(scaled, found.q - q), 1e-9);
    const Mobility told = mobility(scaled, q, 0);
    EXPECT_EQ(told.rank, known.rank);
    EXPECT_EQ(told.rank_by_svd, known.rank_by_svd);
    EXPECT_EQ(told.driven_freedoms, known.driven_freedoms);
    EXPECT_EQ(told.is_singular, known.is_singular);
    EXPECT_EQ(told.redundant.size(), known.redundant.size());
    EXPECT_EQ(told.independent.size(), known.independent.size());
    EXPECT_EQ(told.idle.size(), known.idle.size());
    const MotionState state = motion_state(scaled, q, 0);
    EXPECT_EQ(state.is_determined, moving.is_determined);
    const VectorXd speed = in_unit(phi, moving.velocity, unit);
    EXPECT_LE(largest_of(scaled, state.velocity - speed), 1e-9 * (1 + largest_of(scaled, speed)));
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanisms, EveryUnit, testing::ValuesIn(kNames), [](const auto& test) {
  std::string name = test.param;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
});

}  // namespace
}  // namespace moivre
