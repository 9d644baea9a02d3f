// SPDX-License-Identifier: MIT
// The same for many poses, each arm's count never below what Newton's method finds from random
// starts.
#include <gtest/gtest.h>

#include "random_poses.h"

namespace moivre::test {
namespace {

constexpr std::uint64_t kPoses = 200;
/// Poses of each arm that Newton's method is set on.
constexpr std::uint64_t kHunted = 10;

void expect_all(const Arm& arm, std::uint64_t complex) {
  expect_found(arm, complex, kPoses);
  for (std::uint64_t k = 0; k < kHunted; ++k) expect_no_more(arm, k);
}

TEST(ManyRandomPosesTest, Puma) { expect_all(make_arm(robot_of("puma560"), {}), 8); }
TEST(ManyRandomPosesTest, Ur5) { expect_all(arm_of("ur5", "tool0"), 8); }
TEST(ManyRandomPosesTest, Kinova) {
  expect_all(arm_of("kinova_j2s6s200", "j2s6s200_end_effector"), 8);
}
TEST(ManyRandomPosesTest, PandaWithItsLastJointHeld) {
  expect_all(arm_of("panda", "panda_hand_tcp", {{"panda_joint7", 0.3}}), 8);
}
TEST(ManyRandomPosesTest, ManseurAndDoty) { expect_all(arm_of(kManseurDoty), 16); }
TEST(ManyRandomPosesTest, GeneralArm) { expect_all(arm_of(general_arm(1)), 16); }

}  // namespace
}  // namespace moivre::test
