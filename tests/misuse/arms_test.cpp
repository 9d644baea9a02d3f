// SPDX-License-Identifier: MIT
// Are robots, arms, joint values and poses refused by name where they cannot be meant?
#include <functional>
#include <limits>

#include "moivre/arms/arm_closures.h"
#include "moivre/arms/posture.h"
#include "moivre/arms/rules.h"
#include "moivre/arms/turns.h"
#include "moivre/urdf/mechanism_text.h"
#include "moivre/urdf/read.h"
#include "refused.h"

namespace moivre::test {
namespace {

Robot puma() { return read_urdf(read_source(MOIVRE_SOURCE_DIR "/problems/robots/puma560.urdf")); }

TEST(MisuseTest, AnArmTakesOneFiniteValueForEachJoint) {
  const Arm arm = make_arm(puma(), {});
  const Eigen::VectorXd three = Eigen::VectorXd::Zero(3);
  const std::string word = "the arm has 6 joints, the values are 3";
  expect_refused([&] { return forward_kinematics(arm, three); }, word);
  expect_refused([&] { return joint_frames(arm, three); }, word);
  expect_refused([&] { return posture_of(arm, three); }, word);
  expect_refused([&] { return all_turns(arm, three); }, word);
  expect_refused([&] { return nearest_turns(arm, three, Eigen::VectorXd::Zero(6)); }, word);
  expect_refused([&] { return nearest_turns(arm, Eigen::VectorXd::Zero(6), three); }, "6 joints");
  expect_refused([&] { return distance_from(arm, three, Eigen::VectorXd::Zero(6)); }, word);
  expect_refused([&] { return is_on(arm, SelfMotion{}, three, 0.1); }, word);
  expect_refused([&] { return contains(arm, ArmResult{}, SelfMotion{}, three); }, word);
  expect_refused([&] { return misfit_of(arm, Eigen::Isometry3d::Identity(), three); }, word);
  Eigen::VectorXd placed = three;
  expect_refused([&] { return place_in_limits(arm, placed); }, word);
  expect_refused([&] { return forward_kinematics(arm, Eigen::VectorXd::Constant(6, kNaN)); },
                 "not finite");
}

TEST(MisuseTest, ARotationThatIsNoneIsRefused) {
  const Arm arm = make_arm(puma(), {});
  const Eigen::Isometry3d pose = forward_kinematics(arm, Eigen::VectorXd::Constant(6, 0.3));
  Eigen::Isometry3d scaled = pose;
  scaled.linear() *= 2;
  Eigen::Isometry3d mirrored = pose;
  mirrored.linear().col(0) *= -1;
  Eigen::Isometry3d sheared = pose;
  sheared.linear()(0, 1) += 0.3;
  Eigen::Isometry3d lost = pose;
  lost.translation().x() = kNaN;
  Eigen::Isometry3d projective = pose;
  projective.matrix()(3, 0) = 1;
  const auto refuse = [&](const Eigen::Isometry3d& wrong, const std::string& word) {
    expect_refused([&] { return find_arm_closures(arm, wrong, lanes()); }, "the pose " + word);
    const std::vector<Eigen::Isometry3d> poses{pose, wrong};
    expect_refused([&] { return find_arm_closures(arm, poses, lanes()); }, "pose 1 " + word);
  };
  refuse(scaled, "has no rotation: its columns are not perpendicular and of length 1");
  refuse(sheared, "has no rotation");
  refuse(mirrored, "has a mirrored rotation");
  refuse(lost, "has a number that is not finite");
  refuse(projective, "must have 0 0 0 1 as its last row");
}

TEST(MisuseTest, ARotationTypedWithThreeDecimalsIsTheNearestOne) {
  const Arm arm = make_arm(puma(), {});
  const Eigen::Isometry3d pose = forward_kinematics(arm, Eigen::VectorXd::Constant(6, 0.3));
  Eigen::Isometry3d typed = pose;
  typed.linear() = (pose.linear() * 1000).array().round().matrix() / 1000;
  const ArmResult result = find_arm_closures(arm, typed, lanes());
  EXPECT_EQ(result.counts.real, find_arm_closures(arm, pose, lanes()).counts.real);
  const Eigen::Matrix3d R = result.pose.linear();
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((R - typed.linear()).cwiseAbs().maxCoeff(), 2e-3);
  EXPECT_EQ(workable_pose(pose, "it").matrix(), pose.matrix());
}

TEST(MisuseTest, EverySlipInARobotIsRefusedByName) {
  struct RobotSlip {
    std::string refusal;
    std::function<void(Robot&)> make;
  };
  const std::vector<RobotSlip> slips{
      {"ties a link that is not there", [](Robot& r) { r.joints[1].child = 99; }},
      {"ties a link to itself", [](Robot& r) { r.joints[1].child = r.joints[1].parent; }},
      {"needs an axis that is not zero",
       [](Robot& r) {
         r.joints[2].axis = {0, 0, 0};
       }},
      {"needs finite limits",
       [](Robot& r) {
         r.joints[2].limits = Limits{1, kNaN};
       }},
      {"two links are called", [](Robot& r) { r.links[1].name = r.links[0].name; }},
      {"two joints are called", [](Robot& r) { r.joints[1].name = r.joints[0].name; }},
      {"the root is a link that is not there", [](Robot& r) { r.root = 40; }},
      {"names other joints than name it", [](Robot& r) { r.links[0].children = {77}; }},
      {"mimics a joint that is not there",
       [](Robot& r) {
         r.joints[1].mimic = Mimic{50, 1, 0};
       }},
      {"mimics itself by way of others",
       [](Robot& r) {
         r.joints[1].mimic = Mimic{1, 1, 0};
       }},
  };
  for (const RobotSlip& slip : slips) {
    SCOPED_TRACE(slip.refusal);
    Robot robot = puma();
    slip.make(robot);
    expect_refused([&] { return make_arm(robot, {}); }, slip.refusal);
    expect_refused([&] { return mechanism_text(robot, "puma.urdf"); }, slip.refusal);
  }
  EXPECT_TRUE(broken_rules(puma()).empty());
  EXPECT_TRUE(broken_rules(make_arm(puma(), {})).empty());
}

TEST(MisuseTest, AnArmThatWasChangedIsRefused) {
  Arm arm = make_arm(puma(), {});
  const Eigen::Isometry3d pose = forward_kinematics(arm, Eigen::VectorXd::Constant(6, 0.3));
  arm.joints[2].axis = {2, 0, 0};
  arm.joints[3].before.linear() *= 3;
  expect_refused([&] { return find_arm_closures(arm, pose, lanes()); },
                 "needs an axis of length 1");
  expect_refused([&] { return find_arm_closures(arm, pose, lanes()); }, "has no rotation");
  arm.joints.clear();
  expect_refused([&] { return find_arm_closures(arm, pose, lanes()); }, "one to six joints");
}

TEST(MisuseTest, AChoiceIsRefusedInTheLibrarysWords) {
  expect_refused(
      [] {
        return make_arm(puma(), {"nowhere", {}, {}});
      },
      "there is no link 'nowhere'");
  expect_refused(
      [] {
        return make_arm(puma(), {{}, {}, {{"elbow", 0}}});
      },
      "`held`: there is no joint 'elbow'");
}

}  // namespace
}  // namespace moivre::test
