// SPDX-License-Identifier: MIT
// Is every posture of an arm called by other words, and are they those that an onlooker would use?
#include "moivre/arms/posture.h"

#include <gtest/gtest.h>

#include <set>

#include "robots.h"

namespace moivre::test {
namespace {

std::string words_at(const Arm& arm, const std::vector<double>& values) {
  return to_string(posture_of(
      arm, Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(6))));
}

// A real arm that has all its closures has them under eight names, for every seed and pose.
TEST(PostureTest, EightClosuresHaveEightNames) {
  const std::vector<Arm> arms{make_arm(robot_of("puma560"), {}), arm_of("ur5", "tool0"),
                              arm_of("kinova_j2s6s200", "j2s6s200_end_effector")};
  for (const Arm& arm : arms) {
    std::size_t full = 0;
    for (std::uint64_t k = 0; k < 12; ++k) {
      const Eigen::VectorXd own = random_values(arm, 21, k);
      const ArmResult result =
          find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
      std::set<std::string> names;
      for (const ArmClosure& closure : result.closures) {
        names.insert(to_string(posture_of(arm, closure.values)));
      }
      EXPECT_EQ(names.size(), result.closures.size()) << arm.robot << " pose " << k;
      full += result.closures.size() == 8 ? 1 : 0;
    }
    EXPECT_GE(full, 3U) << arm.robot;
  }
}

// The Puma reaches out to the front, its wrist 0.15 beside axis 1.
TEST(PostureTest, WordsAreThoseOfAnOnlooker) {
  const Arm arm = make_arm(robot_of("puma560"), {});
  const double quarter = std::numbers::pi / 2;
  const std::string reaching_up = words_at(arm, {0, 0.6, -1.2, 0, 0.5, 0});
  const std::string reaching_down = words_at(arm, {0, -0.6, -0.4, 0, -0.5, 0});
  const Eigen::Isometry3d elbow = joint_frames(arm, Eigen::VectorXd::Zero(6))[2];
  ASSERT_GT(elbow.translation().x(), 0.4) << "the upper arm points to x";
  EXPECT_EQ(reaching_up, "shoulder right, elbow down, no flip");
  EXPECT_EQ(reaching_down, "shoulder right, elbow down, flip");
  // Joint 2 turned over the top, joint 1 half round: the other shoulder.
  const bool is_right = *posture_of(arm, Eigen::VectorXd::Zero(6)).is_right;
  Eigen::VectorXd over(6);
  over << 2 * quarter, 2 * quarter, 0, 0, 0.5, 0;
  EXPECT_NE(*posture_of(arm, over).is_right, is_right);
}

TEST(PostureTest, AStraightWristHasNoWordForItsFlip) {
  const Arm arm = make_arm(robot_of("puma560"), {});
  EXPECT_EQ(words_at(arm, {0.3, 0.4, 0.5, 0.2, 0, 0.1}), "shoulder right, elbow down");
}

TEST(PostureTest, AGeneralArmHasNoWords) {
  const Arm arm = arm_of(general_arm(1));
  EXPECT_EQ(to_string(posture_of(arm, random_values(arm, 1, 1))), "");
}

}  // namespace
}  // namespace moivre::test
