// SPDX-License-Identifier: MIT
// Is every posture of a robot in the picture, where its joints are, and another to the eye than its
// neighbours?
#include <gtest/gtest.h>

#include "moivre/arm_report/arm_report.h"
#include "moivre/mechanism/pose.h"
#include "robots.h"
#include "skeleton.h"
#include "well_formed.h"

namespace moivre::test {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

ArmReport report_of(const Arm& arm, std::uint64_t pose) {
  ArmReport report{"arm.urdf", arm, {}};
  const Eigen::VectorXd own = random_values(arm, 21, pose);
  report.results.push_back(
      find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread()));
  return report;
}

std::vector<Arm> arms() {
  return {make_arm(robot_of("puma560"), {}), arm_of("ur5", "tool0"),
          arm_of("kinova_j2s6s200", "j2s6s200_end_effector"),
          arm_of("panda", "panda_hand_tcp", {{"panda_joint7", 0.3}}), arm_of(kManseurDoty)};
}

TEST(ArmPictureTest, EveryClosureHasAPanelInBothForms) {
  for (const Arm& arm : arms()) {
    const ArmReport report = report_of(arm, 1);
    const std::size_t closures = report.results.front().closures.size();
    const std::string svg = arm_svg(report, false);
    EXPECT_EQ(count(svg, "class=\"panel\""), std::max<std::size_t>(closures, 1)) << arm.robot;
    EXPECT_TRUE(Markup(svg).is_well_formed()) << arm.robot;
    EXPECT_EQ(count(arm_html(report, false), "<canvas"), std::max<std::size_t>(closures, 1));
  }
}

// A UR5 with a straight wrist moves, and has closures that stand alone.
TEST(ArmPictureTest, EverySetHasAPanelBesideTheClosures) {
  ArmReport report{"arm.urdf", arm_of("ur5", "tool0"), {}};
  const Eigen::VectorXd own{{0.3, -1.0, 1.2, 0.4, 0, 0.7}};
  report.results.push_back(
      find_arm_closures(report.arm, forward_kinematics(report.arm, own), lanes(), one_thread()));
  const ArmResult& result = report.results.front();
  ASSERT_FALSE(result.moves.empty());
  ASSERT_FALSE(result.closures.empty());
  const std::string svg = arm_svg(report, false);
  EXPECT_EQ(count(svg, "class=\"panel\""), result.closures.size() + result.moves.size());
  EXPECT_EQ(count(svg, "moves, from here") + count(svg, "moves within the digits"),
            result.moves.size());
}

TEST(ArmPictureTest, TheSkeletonEndsWhereTheToolIs) {
  for (const Arm& arm : arms()) {
    const Skeleton skeleton = make_skeleton(arm);
    const Eigen::VectorXd values = random_values(arm, 21, 2);
    const Eigen::VectorXd q = skeleton_pose(skeleton, arm, values);
    const std::size_t last = skeleton.mechanism.bodies.size() - 1;
    const PointOf tip{last, skeleton.mechanism.bodies[last].points.size() - 1};
    const Eigen::Isometry3d tool = forward_kinematics(arm, values);
    EXPECT_LT((point_position(skeleton.mechanism, tip, q) - tool.translation()).norm(), 1e-12);
    for (const Joint& joint : skeleton.mechanism.joints) {
      if (joint.type != JointType::revolute) continue;
      const auto at = [&](std::size_t end) {
        return point_position(skeleton.mechanism, joint.at[end], q);
      };
      EXPECT_LT((at(0) - at(1)).norm(), 1e-12) << "both links hold their joint";
    }
  }
}

// The joints of a wrist have one place; slid along their axes they show which way it is turned.
// Postures that are nearer to each other than a joint is wide show half of what parts them.
TEST(ArmPictureTest, NoTwoPosturesLookAlike) {
  constexpr double kSeen = 0.01;  // of the arm's length: as wide as a joint is drawn
  for (const Arm& arm : arms()) {
    const Skeleton skeleton = make_skeleton(arm);
    for (std::uint64_t pose = 1; pose < 6; ++pose) {
      std::vector<Eigen::VectorXd> poses;
      const auto report = report_of(arm, pose);
      for (const ArmClosure& closure : report.results.front().closures) {
        poses.push_back(skeleton_pose(skeleton, arm, closure.values));
      }
      const Eye eye = best_eye(skeleton, poses);
      for (std::size_t a = 0; a < poses.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          double apart = 0;
          double in_space = 0;
          for (std::size_t body = 1; body < skeleton.mechanism.bodies.size(); ++body) {
            for (std::size_t k = 0; k < skeleton.mechanism.bodies[body].points.size(); ++k) {
              const Eigen::Vector3d way = point_position(skeleton.mechanism, {body, k}, poses[a]) -
                                          point_position(skeleton.mechanism, {body, k}, poses[b]);
              apart = std::max(apart, std::abs(seen(skeleton.mechanism, way, eye)));
              in_space = std::max(in_space, way.norm());
            }
          }
          EXPECT_GT(apart, std::min(kSeen * arm.length, in_space / 2))
              << arm.robot << " pose " << pose;
        }
      }
    }
  }
}

TEST(ArmPictureTest, APoseOutOfReachIsSaidToBe) {
  ArmReport report{"arm.urdf", arm_of("ur5", "tool0"), {}};
  Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
  far.translation() << 3, 1, 0.5;
  report.results.push_back(find_arm_closures(report.arm, far, lanes(), one_thread()));
  EXPECT_EQ(count(arm_svg(report, false), "no closure"), 1U);
  EXPECT_EQ(count(arm_svg(report, false), "class=\"faint\""), 1U);
}

TEST(ArmPictureTest, SeveralPosesAreRefused) {
  ArmReport report = report_of(arm_of("ur5", "tool0"), 1);
  report.results.push_back(report.results.front());
  EXPECT_THROW(arm_svg(report, false), std::invalid_argument);
}

TEST(ArmPictureTest, NamesAreEscaped) {
  Arm arm = make_arm(robot_of("puma560"), {});
  arm.robot = "</title><script>evil";
  arm.tip = "<b>&";
  const std::string svg = arm_svg(report_of(arm, 1), false);
  EXPECT_EQ(count(svg, "<script"), 0U);
  EXPECT_TRUE(Markup(svg).is_well_formed());
  EXPECT_EQ(count(arm_html(report_of(arm, 1), false), "<script>evil"), 0U);
}

}  // namespace
}  // namespace moivre::test
