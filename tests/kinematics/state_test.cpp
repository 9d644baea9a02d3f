// SPDX-License-Identifier: MIT
// Are velocities and accelerations those of the motion, and are partitions chosen and refused?
#include "moivre/kinematics/state.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "../mechanism/files.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::example;

TEST(State, VelocityAndAccelerationAreThoseOfReassembledPoses) {
  for (const char* name :
       {"four-bar", "whitworth", "scotch-yoke", "gear-five-bar", "five-bar",
        "inverted-slider-crank", "jansen-leg", "rssr", "bennett", "double-parallel-crank"}) {
    const Mechanism m = example(name);
    const Phi phi(m);
    const VectorXd q = newton(phi, initial_guess(m)).q;
    const MotionState state = motion_state(phi, q, 0);
    // Speeds of about 1 rad/s: a hundredth of a millisecond is a small step for all examples.
    constexpr double kStep = 1e-5;
    NewtonOptions tight;
    tight.residual_tolerance = 1e-15;
    const VectorXd next = newton(phi, q, kStep, tight).q;
    const VectorXd back = newton(phi, q, -kStep, tight).q;
    const VectorXd velocity = (next - back) / (2 * kStep);
    const VectorXd acceleration = (next - 2 * q + back) / (kStep * kStep);
    EXPECT_LT((state.velocity - velocity).norm(), 1e-6 * (1 + velocity.norm())) << name;
    EXPECT_LT((state.acceleration - acceleration).norm(), 1e-3 * (1 + acceleration.norm())) << name;
    EXPECT_LT(state.velocity_residual, 1e-12 * (1 + velocity.norm())) << name;
    EXPECT_LT(state.acceleration_residual, 1e-11 * (1 + acceleration.norm())) << name;
  }
}

TEST(State, PointsOfTheFourBarMoveAsTheirBody) {
  const Mechanism m = example("four-bar");
  const Phi phi(m);
  const VectorXd q = newton(phi, initial_guess(m)).q;
  const MotionState s = motion_state(phi, q, 0);
  const PointState A = point_state(m, {1, 1}, q, s.velocity, s.acceleration);
  EXPECT_NEAR(A.velocity.norm(), 40 * 25, 1e-10);
  const PointState same = point_state(m, {2, 0}, q, s.velocity, s.acceleration);
  EXPECT_LT((A.acceleration - same.acceleration).norm(), 1e-9);
}

TEST(State, ScotchYokeFollowsTheCosine) {
  const Mechanism m = example("scotch-yoke");
  const Phi phi(m);
  const MotionState s = motion_state(phi, newton(phi, initial_guess(m)).q, 0);
  const double angle = 30 * test::kDegree, speed = 60 * test::kDegree;
  EXPECT_NEAR(s.q[3], 2 * std::cos(angle), 1e-14);
  EXPECT_NEAR(s.velocity[3], -2 * std::sin(angle) * speed, 1e-14);
  EXPECT_NEAR(s.acceleration[3], -2 * std::cos(angle) * speed * speed, 1e-14);
}

TEST(State, UndrivenMechanismIsSaidToBeUndetermined) {
  const Mechanism m = example("four-bar");
  const Phi joints = Phi(m).without_drivers();
  const MotionState s = motion_state(joints, newton(Phi(m), initial_guess(m)).q, 0);
  EXPECT_FALSE(s.is_determined);
  EXPECT_EQ(s.method, LinearMethod::minimum_norm);
  EXPECT_LT(s.velocity.norm(), 1e-15);
}

TEST(State, PartitionRefusesWhatIsNoCoordinate) {
  const Mechanism m = example("four-bar");
  const Phi joints = Phi(m).without_drivers();
  EXPECT_THROW(make_partition(joints, initial_guess(m), {9}), std::invalid_argument);
  EXPECT_THROW(make_partition(joints, initial_guess(m), {2, 2}), std::invalid_argument);
}

TEST(State, UnusablePartitionIsNotSolvedWith) {
  const Mechanism m = example("four-bar");
  const Phi joints = Phi(m).without_drivers();
  const VectorXd q = newton(Phi(m), initial_guess(m)).q;
  const Partition fixed_pivot = make_partition(joints, q, {0});  // crank.x cannot move
  EXPECT_FALSE(fixed_pivot.is_usable());
  EXPECT_THROW(solve_positions(joints, fixed_pivot, q), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
