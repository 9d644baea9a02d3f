// SPDX-License-Identifier: MIT
// Does a joint that is held at many values give the closures of each value, in order, and are
// ranges that mean nothing refused?
#include "moivre/arms/held_range.h"

#include <gtest/gtest.h>

#include <limits>

#include "moivre/numeric/invalid_input.h"
#include "robots.h"

namespace moivre::test {
namespace {

const HeldRange kRange{"panda_joint7", 0.2, 0.8, 4};
const ArmChoice kHand{std::nullopt, "panda_hand_tcp", {}};

TEST(HeldRangeTest, HasBothEndsAndEqualSteps) {
  const std::vector<double> values = values_of(kRange);
  ASSERT_EQ(values.size(), 4U);
  EXPECT_EQ(values.front(), 0.2);
  EXPECT_EQ(values.back(), 0.8);
  EXPECT_NEAR(values[1], 0.4, 1e-15);
  EXPECT_NEAR(values[2], 0.6, 1e-15);
  EXPECT_EQ(values_of({"q", 0.3, 5, 1}), std::vector<double>{0.3});
  EXPECT_EQ(values_of({"q", 1, -1, 2}), (std::vector<double>{1, -1}));
}

TEST(HeldRangeTest, GivesTheClosuresThatTheJointHeldAloneHas) {
  const Robot panda = robot_of("panda");
  const std::vector<Arm> arms = arms_along(panda, kHand, kRange);
  ASSERT_EQ(arms.size(), 4U);
  const Eigen::VectorXd own = random_values(arms[1], 3, 1);
  const TypedPose pose{forward_kinematics(arms[1], own)};
  const auto results = find_closures_of_each(arms, pose, lanes(), one_thread());
  ASSERT_EQ(results.size(), 4U);
  EXPECT_LT(least_distance(arms[1], results[1], own), 1e-9);
  for (std::size_t k = 0; k < arms.size(); ++k) {
    EXPECT_EQ(arms[k].held.back().value, values_of(kRange)[k]);
    const Arm alone = arm_of("panda", "panda_hand_tcp", {{"panda_joint7", values_of(kRange)[k]}});
    const ArmResult expected = find_arm_closures(alone, pose, lanes(), one_thread());
    EXPECT_TRUE(results[k].complete);
    ASSERT_EQ(results[k].closures.size(), expected.closures.size());
    for (std::size_t i = 0; i < expected.closures.size(); ++i) {
      EXPECT_EQ(results[k].closures[i].values, expected.closures[i].values);
    }
  }
}

TEST(HeldRangeTest, RefusesWhatCannotBeMeant) {
  const Robot panda = robot_of("panda");
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(values_of({"q", kNan, 1, 2}), InvalidInput);
  EXPECT_THROW(values_of({"q", 0, 1, 0}), InvalidInput);
  EXPECT_THROW(values_of({"q", 0, 1, 1'000'001}), InvalidInput);
  EXPECT_THROW(arms_along(panda, kHand, {"no_joint", 0, 1, 2}), std::invalid_argument);
  ArmChoice held_too = kHand;
  held_too.held = {{"panda_joint7", 0.5}};
  EXPECT_THROW(arms_along(panda, held_too, kRange), std::invalid_argument);
}

}  // namespace
}  // namespace moivre::test
