// SPDX-License-Identifier: MIT
// Is the chain between two links the robot's, and is a choice that makes none refused, every fault
// named?
#include "moivre/arms/arm.h"

#include <gtest/gtest.h>

#include "robots.h"

namespace moivre::test {
namespace {

std::string refusal_of(const Robot& robot, const ArmChoice& choice) {
  try {
    make_arm(robot, choice);
  } catch (const std::invalid_argument& refusal) {
    return refusal.what();
  }
  return "";
}

TEST(ArmTest, TheTipMustBeChosenWhereTheRobotHasSeveralEnds) {
  const std::string refusal = refusal_of(robot_of("ur5"), {});
  EXPECT_EQ(refusal, "the robot ends in 3 links, choose one by `tip`: ee_link, base, tool0");
}

TEST(ArmTest, SevenFreeJointsAreRefusedWithTheirNames) {
  const std::string refusal = refusal_of(robot_of("panda"), {std::nullopt, "panda_hand_tcp", {}});
  EXPECT_EQ(refusal,
            "there are 7 free joints; with more than six the arm can move while the tip stands. "
            "Hold 1 of them by `held`: panda_joint1, panda_joint2, panda_joint3, "
            "panda_joint4, panda_joint5, panda_joint6, panda_joint7");
}

TEST(ArmTest, EveryFaultOfAChoiceIsNamed) {
  const std::string refusal =
      refusal_of(robot_of("ur5"), {"bas_link", "tool", {{"elbow", 0}, {"world_joint", 1}}});
  EXPECT_EQ(
      refusal,
      "`held`: there is no joint 'elbow'; known are 'shoulder_pan_joint', 'shoulder_lift_joint', "
      "'elbow_joint', 'wrist_1_joint', 'wrist_2_joint', 'wrist_3_joint', 'ee_fixed_joint', "
      "'base_link-base_fixed_joint', ...; `held`: joint 'world_joint' is fixed; there is no link "
      "'bas_link'; did you mean 'base_link'?; there is no link 'tool'; did you mean 'tool0'?");
}

TEST(ArmTest, BaseAndTipAlikeLeaveNoFreeJoint) {
  EXPECT_EQ(refusal_of(robot_of("ur5"), {"tool0", "tool0", {}}),
            "no joint between base and tip is free to move");
}

TEST(ArmTest, AJointThatMimicsAHeldOneIsHeldWithIt) {
  const Robot robot = robot_of("panda");
  const std::vector<HeldJoint> held{{"panda_joint1", 0.1}, {"panda_finger_joint1", 0.02}};
  const Arm arm = make_arm(robot, {std::nullopt, "panda_rightfinger", held});
  EXPECT_EQ(arm.joints.size(), 6U);
  ASSERT_EQ(arm.held.size(), 2U);
  EXPECT_EQ(arm.held[1].name, "panda_finger_joint2");
  EXPECT_EQ(arm.held[1].value, 0.02);
}

/// A turning arm whose j3 stands at 0.5 - 2 j2, and j4 at twice that.
Robot robot_with_followers() {
  return read_urdf({"followers.urdf", R"(<robot name="followers">
<link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/>
<joint name="j1" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<joint name="j2" type="continuous"><parent link="b"/><child link="c"/><origin xyz="1 0 0"/>
  <axis xyz="0 1 0"/></joint>
<joint name="j3" type="continuous"><parent link="c"/><child link="d"/><origin xyz="1 0 0"/>
  <axis xyz="0 1 0"/><mimic joint="j2" multiplier="-2" offset="0.5"/></joint>
<joint name="j4" type="continuous"><parent link="d"/><child link="e"/><origin xyz="1 0 0"/>
  <axis xyz="0 1 0"/><mimic joint="j3" multiplier="2"/></joint>
</robot>)"});
}

TEST(ArmTest, WhatAHeldFollowerFollowsIsHeldWithIt) {
  const Robot robot = robot_with_followers();
  for (const HeldJoint& one : {HeldJoint{"j2", 0.1}, {"j3", 0.3}, {"j4", 0.6}}) {
    const Arm arm = make_arm(robot, {std::nullopt, std::nullopt, {one}});
    ASSERT_EQ(arm.held.size(), 3U) << one.name;
    EXPECT_NEAR(arm.held[0].value, 0.1, 1e-15);
    EXPECT_NEAR(arm.held[1].value, 0.3, 1e-15);
    EXPECT_NEAR(arm.held[2].value, 0.6, 1e-15);
    EXPECT_EQ(arm.joints.size(), 1U);
  }
}

TEST(ArmTest, JointsThatMoveTogetherAreNotHeldApart) {
  const Robot robot = robot_with_followers();
  EXPECT_EQ(refusal_of(robot, {std::nullopt, std::nullopt, {{"j2", 0.1}, {"j4", 0.6}}}), "");
  EXPECT_EQ(refusal_of(robot, {std::nullopt, std::nullopt, {{"j2", 0.1}, {"j4", 0.7}}}),
            "`held`: joint 'j4' moves together with others (mimic) and stands at 0.6 then");
}

TEST(ArmTest, TwoJointsThatMoveTogetherInTheChainAreRefused) {
  const Robot robot = robot_of("panda");
  const std::string refusal = refusal_of(robot, {"panda_leftfinger", "panda_rightfinger", {}});
  EXPECT_EQ(refusal,
            "joints 'panda_finger_joint1' and 'panda_finger_joint2' move together (mimic) and are "
            "both in the chain, which is not supported; hold one of them by `held`");
}

TEST(ArmTest, TheChainUpwardsIsTheInverseOfTheChainDownwards) {
  const Robot robot = robot_of("kinova_j2s6s200");
  const Arm down = make_arm(robot, {"base", "j2s6s200_end_effector", {}});
  const Arm up = make_arm(robot, {"j2s6s200_end_effector", "base", {}});
  const Eigen::VectorXd values = random_values(down, 1, 1);
  const Eigen::Isometry3d there = forward_kinematics(down, values);
  const Eigen::Isometry3d back = forward_kinematics(up, values.reverse());
  EXPECT_LT(((there * back).matrix() - Eigen::Matrix4d::Identity()).cwiseAbs().maxCoeff(), 1e-14);
  const ArmResult result = find_arm_closures(up, back, lanes(), one_thread());
  EXPECT_LT(least_distance(up, result, values.reverse()), 1e-9);
}

TEST(ArmTest, ForwardKinematicsIsTheProductOfTheTransformsAsTyped) {
  const Arm arm = arm_of(kPuma);
  Eigen::VectorXd values(6);
  values << 20, -30, 50, -140, -60, 110;
  const Eigen::Isometry3d tip = forward_kinematics(arm, values * std::numbers::pi / 180);
  EXPECT_NEAR(tip.translation().x(), 0.28186546747901, 1e-14);
  EXPECT_NEAR(tip.translation().y(), -0.05708923453012271, 1e-14);
  EXPECT_NEAR(tip.linear()(0, 0), 0.7624523637705527, 1e-14);
}

}  // namespace
}  // namespace moivre::test
