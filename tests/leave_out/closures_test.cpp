// SPDX-License-Identifier: MIT
// Do closures leave out velocities and accelerations? Nobody asked for them.
#include "moivre/closures/closures.h"

#include <gtest/gtest.h>

#include "moivre/mechanism/read.h"
#include "moivre/tracker_cvode/cvode_tracker.h"
#include "wrapped_kinematics.h"

namespace moivre {
namespace {

TEST(LeaveOut, ClosuresAskForNoVelocity) {
  const Mechanism mechanism = read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml"));
  ClosureOptions options;
  options.solve.threads = 1;
  ClosureResult result;
  int velocity_calls = 0;
  const int acceleration_calls = test::accelerations.calls_of([&] {
    velocity_calls = test::velocities.calls_of(
        [&] { result = find_closures(mechanism, *make_cvode_tracker(), options); });
  });
  EXPECT_EQ(result.closures.size(), 2U);
  EXPECT_EQ(velocity_calls, 0);
  EXPECT_EQ(acceleration_calls, 0);
}

}  // namespace
}  // namespace moivre
