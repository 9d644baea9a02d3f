// SPDX-License-Identifier: MIT
// Does kinematics factor once for velocity and acceleration, and ask for neither where only a pose
// is wanted?
#include <gtest/gtest.h>

#include "counted_calls.h"
#include "moivre/factorization/qr.h"
#include "moivre/kinematics/state.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/read.h"

namespace moivre {
namespace {

using Velocities = test::Counted<&Phi::velocity_rhs>;
using Accelerations = test::Counted<&Phi::acceleration_rhs>;
/// A factorization asks for the rank of its matrix, once.
using Factorizations = test::Counted<&PivotedQr<double>::rank>;

struct FourBar {
  Mechanism mechanism = read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml"));
  Phi phi{mechanism};
  NewtonResult pose = newton(phi, initial_guess(mechanism, 0));
};

TEST(LeaveOut, NewtonAsksForNoVelocity) {
  int velocity_calls = 0;
  const int acceleration_calls = test::calls_of<Accelerations>([&] {
    velocity_calls = test::calls_of<Velocities>(
        [] { EXPECT_EQ(FourBar().pose.status, NewtonStatus::converged); });
  });
  EXPECT_EQ(velocity_calls, 0);
  EXPECT_EQ(acceleration_calls, 0);
}

TEST(LeaveOut, AccelerationIsSolvedWithTheFactorsOfVelocity) {
  const FourBar four_bar;
  MotionState state;
  const int calls = test::calls_of<Factorizations>(
      [&] { state = motion_state(four_bar.phi, four_bar.pose.q, 0); });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(state.factorizations, 1);
}

TEST(LeaveOut, PartitionedAccelerationIsSolvedWithTheFactorsOfVelocity) {
  const FourBar four_bar;
  const Phi joints = four_bar.phi.without_drivers();
  const Partition partition = choose_partition(joints, four_bar.pose.q);
  const Eigen::VectorXd one =
      Eigen::VectorXd::Ones(static_cast<Eigen::Index>(partition.independent.size()));
  const int calls = test::calls_of<Factorizations>(
      [&] { partitioned_state(joints, partition, four_bar.pose.q, one, one); });
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace moivre
