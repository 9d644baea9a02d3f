// SPDX-License-Identifier: MIT
// Is the mechanism that a robot becomes the same robot? It is read without a fault, and its joints
// leave its freedoms.
#include "moivre/urdf/mechanism_text.h"

#include <gtest/gtest.h>

#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/read.h"
#include "moivre/urdf/placement.h"
#include "moivre/urdf/read.h"

namespace moivre {
namespace {

Robot robot_of(const std::string& name) {
  return read_urdf(read_source(MOIVRE_SOURCE_DIR "/problems/robots/" + name + ".urdf"));
}

Mechanism mechanism_of(const Robot& robot) {
  return read_mechanism({robot.name + ".toml", mechanism_text(robot, robot.name)});
}

TEST(MechanismTextTest, EveryRobotIsAMechanismThatIsAssembledWhereAllJointsAreZero) {
  for (const std::string name : {"ur5", "panda", "kinova_j2s6s200", "puma560"}) {
    SCOPED_TRACE(name);
    const Robot robot = robot_of(name);
    const Mechanism mechanism = mechanism_of(robot);
    EXPECT_EQ(mechanism.bodies.size(), robot.links.size());
    EXPECT_EQ(mechanism.joints.size(), robot.joints.size());
    EXPECT_TRUE(mechanism.warnings.empty());
    const Phi phi(mechanism);
    EXPECT_LT(scaled_residual(phi, initial_guess(mechanism), 0), 1e-12);
  }
}

TEST(MechanismTextTest, LinksStandWhereTheRobotsTransformsPutThem) {
  const Robot robot = robot_of("kinova_j2s6s200");
  const Mechanism mechanism = mechanism_of(robot);
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  for (std::size_t k = 0; k < 8; ++k) {  // the chain to the end effector is in the file's order
    at += frame * to_vector(robot.joints[k].xyz);
    frame *= rotation(robot.joints[k].rpy);
  }
  std::size_t body = 0;
  while (mechanism.bodies[body].name != "j2s6s200_end_effector") ++body;
  const Eigen::VectorXd q = initial_guess(mechanism);
  EXPECT_LT((point_position(mechanism, {body, 0}, q) - at).norm(), 1e-9);
}

TEST(MechanismTextTest, MimicsAreDrivenTogetherWithTheirLeader) {
  const Mechanism mechanism = mechanism_of(robot_of("panda"));
  ASSERT_EQ(mechanism.drivers.size(), 2U);
  EXPECT_EQ(mechanism.drivers[0].name, "panda_finger_joint1");
  EXPECT_EQ(mechanism.drivers[1].name, "panda_finger_joint2");
}

TEST(MechanismTextTest, NamesThatAMechanismFileDoesNotTakeAreChanged) {
  const Robot robot = read_urdf(
      {"r",
       "<robot name='a \"robot\"'><link name='the base'/><link name='ground'/>"
       "<link name='gro/und'/><link name='gro und'/>"
       "<joint name='j 1' type='continuous'><parent link='the base'/><child link='ground'/>"
       "</joint><joint name='j_1' type='fixed'><parent link='ground'/><child link='gro/und'/>"
       "</joint><joint name='j:1' type='fixed'><parent link='ground'/><child link='gro und'/>"
       "</joint></robot>"});
  const std::string text = mechanism_text(robot, "file\nname");
  EXPECT_NO_THROW(read_mechanism({"r.toml", text})) << text;
}

TEST(MechanismTextTest, ARobotOfOneLinkIsNoMechanism) {
  const Robot robot = read_urdf({"r", "<robot name='r'><link name='a'/></robot>"});
  EXPECT_THROW(mechanism_text(robot, "r.urdf"), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
