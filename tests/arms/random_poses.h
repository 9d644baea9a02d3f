// SPDX-License-Identifier: MIT
// What must hold for poses that an arm can reach? And does Newton's method from random starts ever
// find a closure more?
#pragma once

#include <gtest/gtest.h>

#include "../../src/arms/polish.h"
#include "robots.h"

namespace moivre::test {

/// Poses of random joint values: these among the closures, all true, as many complex ones as the
/// arm's kind has.
inline void expect_found(const Arm& arm, std::uint64_t complex, std::uint64_t poses) {
  for (std::uint64_t k = 0; k < poses; ++k) {
    SCOPED_TRACE("pose " + std::to_string(k));
    const Eigen::VectorXd own = random_values(arm, 11, k);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread(k + 1));
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, complex);
    EXPECT_LT(least_distance(arm, result, own), 1e-9);
    EXPECT_LT(worst_miss(arm, result), 1e-10);
  }
}

/// Every pose that Newton's method ends at is among the closures.
inline void expect_no_more(const Arm& arm, std::uint64_t pose) {
  constexpr std::uint64_t kStarts = 100;
  const Eigen::Isometry3d wanted = forward_kinematics(arm, random_values(arm, 11, pose));
  const ArmResult result = find_arm_closures(arm, wanted, lanes(), one_thread());
  for (std::uint64_t k = 0; k < kStarts; ++k) {
    const Polished there = polish(arm, wanted, random_values(arm, 12, pose * kStarts + k), true);
    if (there.residual > kReach) continue;
    EXPECT_LT(least_distance(arm, result, there.values), 1e-6) << "pose " << pose << " start " << k;
  }
}

}  // namespace moivre::test
