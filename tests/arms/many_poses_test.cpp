// SPDX-License-Identifier: MIT
// Do many poses have the closures that each has alone, by a formula or the family where these
// answer and without them where not?
#include <gtest/gtest.h>

#include "robots.h"

namespace moivre::test {
namespace {

std::vector<Eigen::Isometry3d> random_poses(const Arm& arm, std::uint64_t count) {
  std::vector<Eigen::Isometry3d> poses;
  for (std::uint64_t k = 0; k < count; ++k) {
    poses.push_back(forward_kinematics(arm, random_values(arm, 6, k)));
  }
  return poses;
}

std::size_t answered_by(const std::vector<ArmResult>& results, StartSource source) {
  return static_cast<std::size_t>(
      std::count_if(results.begin(), results.end(),
                    [source](const ArmResult& result) { return result.start.source == source; }));
}

void expect_same(const Arm& arm, const ArmResult& a, const ArmResult& b) {
  EXPECT_EQ(a.complete, b.complete);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.counts.complex, b.counts.complex);
  EXPECT_EQ(a.counts.beyond_limits, b.counts.beyond_limits);
  ASSERT_EQ(a.closures.size(), b.closures.size());
  for (std::size_t k = 0; k < a.closures.size(); ++k) {
    EXPECT_EQ(a.closures[k].id, b.closures[k].id);
    EXPECT_EQ(a.closures[k].beyond, b.closures[k].beyond);
    EXPECT_LT(distance(arm, a.closures[k].values, b.closures[k].values), 1e-9);
  }
}

TEST(ManyPosesTest, HaveTheClosuresThatEachHasAlone) {
  const std::vector<Arm> arms{make_arm(robot_of("puma560"), {}),
                              arm_of("ur5", "tool0"),
                              arm_of("kinova_j2s6s200", "j2s6s200_end_effector"),
                              arm_of("panda", "panda_hand_tcp", {{"panda_joint7", 0.3}}),
                              arm_of(kManseurDoty),
                              arm_of(general_arm(1))};
  for (const Arm& arm : arms) {
    SCOPED_TRACE(arm.robot);
    const auto poses = random_poses(arm, 12);
    const auto many = find_arm_closures(arm, poses, lanes(), one_thread());
    ASSERT_EQ(many.size(), poses.size());
    EXPECT_GE(answered_by(many, StartSource::formula), 11U);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      expect_same(arm, many[k], find_arm_closures(arm, poses[k], lanes(), one_thread(k + 5)));
    }
  }
}

TEST(ManyPosesTest, SpecialPosesAmongThemAreSolvedAlone) {
  const Arm arm = make_arm(robot_of("puma560"), {});
  auto poses = random_poses(arm, 8);
  Eigen::VectorXd straight(6);
  straight << 0.3, 0.4, 0.5, 0.2, 0, 0.1;  // its wrist moves
  Eigen::VectorXd stretched(6);
  stretched << 0.3, 0.4, std::atan2(0.4318, 0.0203) - std::numbers::pi, 0.2, 0.7, 0.1;
  poses.insert(poses.begin() + 3, forward_kinematics(arm, straight));
  poses.insert(poses.begin() + 5, forward_kinematics(arm, stretched));
  Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
  far.translation() << 3, 1, 0.5;
  poses.push_back(far);
  const auto many = find_arm_closures(arm, poses, lanes(), one_thread());
  ASSERT_EQ(many.size(), poses.size());
  EXPECT_FALSE(many[3].moves.empty());
  EXPECT_EQ(many[3].start.source, StartSource::approach);
  EXPECT_EQ(answered_by(many, StartSource::formula), poses.size() - 1);
  EXPECT_TRUE(many.back().closures.empty());
  for (const std::size_t k : {std::size_t{3}, std::size_t{5}, poses.size() - 1}) {
    SCOPED_TRACE(k);
    const ArmResult alone = find_arm_closures(arm, poses[k], lanes(), one_thread());
    EXPECT_EQ(many[k].complete, alone.complete);
    EXPECT_EQ(many[k].message, alone.message);
    EXPECT_EQ(many[k].counts.complex, alone.counts.complex);
    EXPECT_EQ(many[k].closures.size(), alone.closures.size());
  }
}

void expect_same_with_three_threads(const Arm& arm) {
  const auto poses = random_poses(arm, 20);
  SolveOptions three = one_thread();
  three.threads = 3;
  const auto a = find_arm_closures(arm, poses, lanes(), one_thread());
  const auto b = find_arm_closures(arm, poses, lanes(), three);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].closures.size(), b[k].closures.size());
    for (std::size_t i = 0; i < a[k].closures.size(); ++i) {
      EXPECT_EQ(a[k].closures[i].values, b[k].closures[i].values) << "the same to the last bit";
    }
  }
}

TEST(ManyPosesTest, TheNumberOfThreadsChangesNothing) {
  expect_same_with_three_threads(arm_of(general_arm(2)));
  expect_same_with_three_threads(arm_of(kKr6));
}

TEST(ManyPosesTest, WhichOthersAreInTheListChangesNothing) {
  const Arm arm = arm_of(kXarm5);
  const auto poses = random_poses(arm, 17);
  const auto all = find_arm_closures(arm, poses, lanes(), one_thread());
  const std::vector<Eigen::Isometry3d> last(poses.begin() + 8, poses.end());
  const auto some = find_arm_closures(arm, last, lanes(), one_thread());
  for (std::size_t k = 0; k < some.size(); ++k) {
    ASSERT_EQ(all[k + 8].closures.size(), some[k].closures.size());
    for (std::size_t i = 0; i < some[k].closures.size(); ++i) {
      EXPECT_EQ(all[k + 8].closures[i].values, some[k].closures[i].values);
    }
  }
}

TEST(ManyPosesTest, OfFiveJointsHaveTheClosuresAndTheNearestPostureThatEachHasAlone) {
  const Arm arm = arm_of(kXarm5);
  auto poses = random_poses(arm, 8);
  poses.back().translation().x() += 0.3;  // cannot be held
  const auto many = find_arm_closures(arm, poses, lanes(), one_thread());
  EXPECT_GE(answered_by(many, StartSource::formula), 7U);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    SCOPED_TRACE(k);
    const ArmResult alone = find_arm_closures(arm, poses[k], lanes(), one_thread(k + 5));
    expect_same(arm, many[k], alone);
    ASSERT_EQ(many[k].nearest.has_value(), alone.nearest.has_value());
    if (!alone.nearest) continue;
    EXPECT_NEAR(many[k].nearest->misfit, alone.nearest->misfit, 1e-3);
  }
}

/// Of 100 poses 10 have a closure with a joint near half a turn: in tangents it lies far out, and
/// its condition is large.
TEST(ManyPosesTest, EveryRandomPoseOfAGeneralArmIsAnsweredByTheFormula) {
  const auto many = find_arm_closures(arm_of(kManseurDoty), random_poses(arm_of(kManseurDoty), 100),
                                      lanes(), one_thread());
  EXPECT_EQ(answered_by(many, StartSource::formula), 100U);
}

/// Five turns and a slide, no three of which make a group.
Arm general_arm_with_slide() {
  Robot robot = robot_of(general_arm(1));
  robot.joints[2].type = RobotJointType::prismatic;
  robot.joints[2].limits = Limits{-1, 1};
  return make_arm(robot, {});
}

TEST(ManyPosesTest, PosesOfAGeneralArmWithASlideAreAnsweredByTheFamily) {
  const Arm arm = general_arm_with_slide();
  const auto poses = random_poses(arm, 20);
  const auto many = find_arm_closures(arm, poses, lanes(), one_thread());
  EXPECT_GE(answered_by(many, StartSource::family), 19U);
  // With seed 7 the regular pose has closures at which the slide is far from real.
  for (std::size_t k = 0; k < 3; ++k) {
    expect_same(arm, many[k], find_arm_closures(arm, poses[k], lanes(), one_thread(k + 5)));
  }
}

TEST(ManyPosesTest, FewPosesOfAGeneralArmWithASlideAreSolvedOneByOne) {
  const Arm arm = general_arm_with_slide();
  const auto many = find_arm_closures(arm, random_poses(arm, 3), lanes(), one_thread());
  EXPECT_EQ(answered_by(many, StartSource::family), 0U);
}

TEST(ManyPosesTest, AStartThatIsAskedForIsTaken) {
  const Arm arm = arm_of("ur5", "tool0");
  SolveOptions options = one_thread();
  options.start = StartKind::total_degree;
  const auto many = find_arm_closures(arm, random_poses(arm, 9), lanes(), options);
  EXPECT_EQ(answered_by(many, StartSource::formula) + answered_by(many, StartSource::family), 0U);
}

}  // namespace
}  // namespace moivre::test
