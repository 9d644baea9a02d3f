// SPDX-License-Identifier: MIT
// Does kinematics factor once for velocity and acceleration, and ask for neither where only a pose
// is wanted?
#include <gtest/gtest.h>

#include "moivre/kinematics/state.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/mechanism/read.h"
#include "wrapped_kinematics.h"

namespace moivre {
namespace {

using test::accelerations;
using test::factorizations;
using test::velocities;

struct FourBar {
  Mechanism mechanism = read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml"));
  Phi phi{mechanism};
  NewtonResult pose = newton(phi, initial_guess(mechanism, 0));
};

TEST(LeaveOut, NewtonAsksForNoVelocity) {
  int velocity_calls = 0;
  const int acceleration_calls = accelerations.calls_of([&] {
    velocity_calls =
        velocities.calls_of([] { EXPECT_EQ(FourBar().pose.status, NewtonStatus::converged); });
  });
  EXPECT_EQ(velocity_calls, 0);
  EXPECT_EQ(acceleration_calls, 0);
}

TEST(LeaveOut, AccelerationIsSolvedWithTheFactorsOfVelocity) {
  const FourBar four_bar;
  MotionState state;
  const int calls =
      factorizations.calls_of([&] { state = motion_state(four_bar.phi, four_bar.pose.q, 0); });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(state.factorizations, 1);
}

TEST(LeaveOut, PartitionedAccelerationIsSolvedWithTheFactorsOfVelocity) {
  const FourBar four_bar;
  const Phi joints = four_bar.phi.without_drivers();
  const Partition partition = choose_partition(joints, four_bar.pose.q);
  const Vector one = Vector::Ones(static_cast<Eigen::Index>(partition.independent.size()));
  const int calls = factorizations.calls_of(
      [&] { partitioned_state(joints, partition, four_bar.pose.q, one, one); });
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace moivre
