// SPDX-License-Identifier: MIT
// Of poses made from random joint values: are these values always among the closures, each closure
// true, the count that of its kind?
#include "random_poses.h"

#include <gtest/gtest.h>

namespace moivre::test {
namespace {

constexpr std::uint64_t kPoses = 25;

TEST(RandomPosesTest, Puma) { expect_found(make_arm(robot_of("puma560"), {}), 8, kPoses); }
TEST(RandomPosesTest, Ur5) { expect_found(arm_of("ur5", "tool0"), 8, kPoses); }
TEST(RandomPosesTest, Kinova) {
  expect_found(arm_of("kinova_j2s6s200", "j2s6s200_end_effector"), 8, kPoses);
}
TEST(RandomPosesTest, PandaWithItsLastJointHeld) {
  expect_found(arm_of("panda", "panda_hand_tcp", {{"panda_joint7", 0.3}}), 8, kPoses);
}
TEST(RandomPosesTest, PandaWithItsElbowHeldIsGeneral) {
  expect_found(arm_of("panda", "panda_hand_tcp", {{"panda_joint3", 0.3}}), 16, kPoses);
}
TEST(RandomPosesTest, ManseurAndDoty) { expect_found(arm_of(kManseurDoty), 16, kPoses); }
TEST(RandomPosesTest, GeneralArms) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) expect_found(arm_of(general_arm(seed)), 16, 8);
}

}  // namespace
}  // namespace moivre::test
