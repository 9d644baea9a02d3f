// SPDX-License-Identifier: MIT
// Has a controller every choice of whole turns that its joints' limits allow, and the posture
// nearest to where it stands first?
#include "moivre/arms/turns.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "moivre/numeric/invalid_input.h"
#include "robots.h"

namespace moivre::test {
namespace {

/// A UR5's joints turn by a whole turn either way, its elbow by a half.
Arm ur5() { return arm_of("ur5", "tool0"); }

TEST(Turns, AreAllThatTheLimitsAllowAndHoldTheSamePose) {
  const Arm arm = ur5();
  Eigen::VectorXd values(6);
  values << 0.3, -1.2, 1.9, 2.5, -0.7, 3.0;
  const auto all = all_turns(arm, values);
  ASSERT_EQ(all.size(), 32U);
  for (const Eigen::VectorXd& turned : all) {
    Eigen::VectorXd within = turned;
    EXPECT_TRUE(place_in_limits(arm, within).empty());
    EXPECT_EQ((within - turned).norm(), 0);
    EXPECT_LT(distance(arm, turned, values), 1e-12);
  }
  values[0] = 0;  // from one limit to the other
  EXPECT_EQ(all_turns(arm, values).size(), 48U);
}

TEST(Turns, AreNotOrderedByRounding) {
  const Arm arm = ur5();
  std::vector<ArmClosure> closures(2);
  closures[0].id = "E";
  closures[0].in_limits = Eigen::VectorXd::Constant(6, 0.25);
  closures[1].id = "F";
  closures[1].in_limits = closures[0].in_limits;
  closures[0].in_limits[2] = 2.5 + 1e-14;  // the same elbow, and so the same distance
  closures[1].in_limits[2] = 2.5;
  sort_by_distance(arm, Eigen::VectorXd::Zero(6), closures);
  EXPECT_EQ(closures[0].id, "E");
}

TEST(Turns, OfAJointWithoutLimitsAreNotListed) {
  Arm arm = ur5();
  arm.joints[3].limits.reset();
  const Eigen::VectorXd values = Eigen::VectorXd::Constant(6, 0.5);
  EXPECT_EQ(all_turns(arm, values).size(), 16U);
}

TEST(Turns, ThatNoLimitAsksForAreWithinAHalf) {
  Arm arm = ur5();
  arm.joints[3].limits.reset();
  arm.joints[4].limits = Limits{-0.1, 0.1};
  Eigen::VectorXd values(6);
  values << 5, -6, 7, 7.2, 7.2, -9;
  const Eigen::VectorXd given = values;
  EXPECT_EQ(place_in_limits(arm, values), std::vector<std::size_t>{4});
  EXPECT_EQ(values[0], 5) << "a UR5 turns so far";
  EXPECT_NEAR(values[2], 7 - 2 * std::numbers::pi, 1e-15);
  EXPECT_NEAR(values[3], 7.2 - 2 * std::numbers::pi, 1e-15) << "without limits";
  EXPECT_NEAR(values[4], 7.2 - 2 * std::numbers::pi, 1e-15) << "beyond them";
  EXPECT_LT(distance(arm, values, given), 1e-12);
}

TEST(Turns, ThatAreTooManyAreRefusedByTheJointsName) {
  Arm arm = ur5();
  for (ArmJoint& joint : arm.joints) joint.limits = Limits{-100, 100};
  EXPECT_THROW(require_few_turns(arm), InvalidInput);
  EXPECT_NO_THROW(require_few_turns(ur5()));
}

TEST(Turns, TheNearestClosureIsFirstAndTurnsAsTheArmStands) {
  const Arm arm = ur5();
  Eigen::VectorXd stands(6);
  stands << 5.9, -1.2, 1.9, -4.1, -0.7, -3.5;
  const Eigen::Isometry3d pose = forward_kinematics(arm, stands);
  std::vector<ArmClosure> closures = find_arm_closures(arm, pose, lanes(), one_thread()).closures;
  ASSERT_EQ(closures.size(), 8U);
  sort_by_distance(arm, stands, closures);
  EXPECT_LT((closures.front().in_limits - stands).cwiseAbs().maxCoeff(), 1e-9);
  double before = 0;
  for (const ArmClosure& closure : closures) {
    const double here = distance_from(arm, closure.in_limits, stands);
    EXPECT_GE(here, before);
    before = here;
    for (const Eigen::VectorXd& turned : all_turns(arm, closure.values)) {
      EXPECT_GE(distance_from(arm, turned, stands), here - 1e-12);
    }
  }
}

TEST(Turns, WhereTheArmStandsIsAValueForEachJoint) {
  std::vector<ArmClosure> closures;
  EXPECT_THROW(sort_by_distance(ur5(), Eigen::VectorXd::Zero(5), closures), InvalidInput);
  EXPECT_THROW(
      sort_by_distance(ur5(), Eigen::VectorXd::Constant(6, std::numeric_limits<double>::infinity()),
                       closures),
      InvalidInput);
}

}  // namespace
}  // namespace moivre::test
