// SPDX-License-Identifier: MIT
// Are links, joints and numbers those of the file, exactly?
#include "moivre/urdf/read.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

Robot robot_of(const std::string& name) {
  return read_urdf(read_source(MOIVRE_SOURCE_DIR "/problems/robots/" + name + ".urdf"));
}

TEST(ReadUrdfTest, Ur5HasItsTreeAndItsLeaves) {
  const Robot robot = robot_of("ur5");
  EXPECT_EQ(robot.name, "ur5");
  EXPECT_EQ(robot.links.size(), 11U);
  EXPECT_EQ(robot.joints.size(), 10U);
  EXPECT_EQ(robot.links[robot.root].name, "world");
  EXPECT_EQ(leaves(robot).size(), 3U);
}

TEST(ReadUrdfTest, DecimalsAreExact) {
  const Robot robot = robot_of("ur5");
  const RobotJoint& lift = robot.joints[joint_named(robot, "shoulder_lift_joint").value()];
  EXPECT_EQ(lift.xyz[1], Rational(13585, 100000));
  EXPECT_EQ(lift.rpy[1], Rational(157079632679, 100000000000));
  EXPECT_EQ(lift.axis[1], Rational(1));
}

TEST(ReadUrdfTest, NumbersMayBeWrittenAsProgramsWriteThem) {
  const Robot robot = read_urdf(
      {"r",
       "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='continuous'>"
       "<parent link='a'/><child link='b'/><origin xyz='1. -.5  +2.5E-1'\n rpy='\t0 -0 1e0 '/>"
       "</joint></robot>"});
  EXPECT_EQ(robot.joints[0].xyz[0], Rational(1));
  EXPECT_EQ(robot.joints[0].xyz[1], Rational(-1, 2));
  EXPECT_EQ(robot.joints[0].xyz[2], Rational(1, 4));
  EXPECT_EQ(robot.joints[0].rpy[2], Rational(1));
  EXPECT_EQ(robot.joints[0].axis[0], Rational(1)) << "the axis is x where none is given";
}

TEST(ReadUrdfTest, PandasSecondFingerMimicsTheFirst) {
  const Robot robot = robot_of("panda");
  const RobotJoint& finger = robot.joints[joint_named(robot, "panda_finger_joint2").value()];
  ASSERT_TRUE(finger.mimic);
  EXPECT_EQ(robot.joints[finger.mimic->leader].name, "panda_finger_joint1");
  EXPECT_EQ(finger.mimic->multiplier, 1);
  EXPECT_EQ(finger.limits->upper, 0.04);
}

TEST(ReadUrdfTest, LimitsOfJointsThatTurnWithoutEndAreNone) {
  const Robot robot = robot_of("kinova_j2s6s200");
  const RobotJoint& joint = robot.joints[joint_named(robot, "j2s6s200_joint_1").value()];
  EXPECT_EQ(joint.type, RobotJointType::continuous);
  EXPECT_FALSE(joint.limits);
}

TEST(ReadUrdfTest, WhatDrawsOrWeighsTheRobotIsPassedOver) {
  const Robot robot =
      read_urdf({"r",
                 "<?xml version='1.0'?><!-- made by hand --><robot name='r'><material name='blue'/>"
                 "<link name='a'><visual><origin xyz='x'/></visual><inertial/></link><gazebo/>"
                 "<transmission name='t'><joint name='j'/></transmission></robot>"});
  EXPECT_EQ(robot.links.size(), 1U);
  EXPECT_TRUE(robot.joints.empty());
}

}  // namespace
}  // namespace moivre
