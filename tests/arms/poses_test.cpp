// SPDX-License-Identifier: MIT
// Are poses read as people and programs write them, and every fault named?
#include "moivre/arms/poses.h"

#include <gtest/gtest.h>

namespace moivre {
namespace {

std::vector<Diagnostic> faults_of(const std::string& text) {
  try {
    read_poses({"poses.csv", text});
  } catch (const ParseError& error) {
    return error.diagnostics();
  }
  return {};
}

TEST(PosesTest, NumbersStandBetweenBlanksOrCommasBelowALineOfNames) {
  const auto poses = read_poses(
      {"poses.csv", "x,y,z,qw,qx,qy,qz\r\n# home\n1,2,3,1,0,0,0\r\n\n  4 5\t6; 0 0 -1 0  \n"});
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].pose.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(poses[0].pose.linear(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(poses[1].pose.translation(), Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(poses[1].pose.linear().diagonal(), Eigen::Vector3d(-1, 1, -1));
}

TEST(PosesTest, ARoundedQuaternionIsScaled) {
  const auto poses = read_poses({"--pose", "0 0 0 0.71 0.71 0 0"});
  EXPECT_NEAR(poses[0].pose.linear()(2, 1), 1, 1e-15);
}

TEST(PosesTest, EveryFaultIsNamedAtItsPlace) {
  const auto faults = faults_of("1 2 3 1 0 0\n1 2 3 2 0 0 0\n1 2 x 1 0 0 nan\n1 2 3 1 0 0 0\n");
  ASSERT_EQ(faults.size(), 4U);
  EXPECT_EQ(faults[0].at.line, 1U);
  EXPECT_EQ(faults[0].message, "a pose is seven numbers, x y z qw qx qy qz, not 6");
  EXPECT_EQ(faults[1].at.line, 2U);
  EXPECT_EQ(faults[1].at.column, 7U);
  EXPECT_EQ(faults[2].at.column, 5U);
  EXPECT_EQ(faults[3].at.column, 13U);
}

TEST(PosesTest, AFileWithoutAPoseIsAFault) {
  EXPECT_EQ(faults_of("").size(), 1U);
  EXPECT_EQ(faults_of("x y z qw qx qy qz\n").size(), 1U);
}

}  // namespace
}  // namespace moivre
