// SPDX-License-Identifier: MIT
// Do poses and arms that defeat other programs have all their closures, too? Tools that point
// straight down, straight arms, arms that miss their geometry a little, slides, few joints.
#include <gtest/gtest.h>

#include "robots.h"

namespace moivre::test {
namespace {

Eigen::Isometry3d pointing_down(double x, double y, double z) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(x, y, z));
  pose.rotate(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
  return pose;
}

TEST(SpecialPosesTest, ToolsThatPointStraightDownHaveAllTheirClosures) {
  for (const auto& [name, tip] : {std::pair("ur5", "tool0"), std::pair("puma560", "flange"),
                                  std::pair("kinova_j2s6s200", "j2s6s200_end_effector")}) {
    SCOPED_TRACE(name);
    const Arm arm = arm_of(name, tip);
    const ArmResult result =
        find_arm_closures(arm, pointing_down(-0.35, 0.2, 0.15), lanes(), one_thread());
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.counts.complex, 8U);
    EXPECT_GE(result.counts.real, 4U);
    EXPECT_LT(worst_miss(arm, result), 1e-10);
  }
}

TEST(SpecialPosesTest, ACalibratedArmHasTheClosuresOfAGeneralOne) {
  for (const double size : {1e-2, 1e-4, 1e-6}) {
    SCOPED_TRACE(size);
    const Arm arm = make_arm(disturbed(robot_of("ur5"), size), {std::nullopt, "tool0", {}});
    const Eigen::VectorXd own = random_values(arm, 4, 4);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.counts.complex, 16U);
    EXPECT_LT(least_distance(arm, result, own), 1e-9);
  }
}

TEST(SpecialPosesTest, AStraightWristMoves) {
  const Arm arm = make_arm(robot_of("puma560"), {});
  Eigen::VectorXd own(6);
  own << 0.3, 0.4, 0.5, 0.2, 0, 0.1;
  const ArmResult result =
      find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
  ASSERT_FALSE(result.moves.empty());
  Eigen::VectorXd further =
      result.moves.front().values + 1e-4 * result.moves.front().directions.col(0);
  const double missed =
      (forward_kinematics(arm, further).matrix() - result.pose.matrix()).cwiseAbs().maxCoeff();
  EXPECT_LT(missed, 1e-7);
  // The tip cannot turn across the plane of the wrist's two axes that are not one.
  const std::vector<Eigen::Isometry3d> frames = joint_frames(arm, result.moves.front().values);
  const Eigen::Vector3d four = frames[3].linear() * arm.joints[3].axis;
  const Eigen::Vector3d five = frames[4].linear() * arm.joints[4].axis;
  const Twist& lost = result.moves.front().lost;
  EXPECT_LT(std::abs(lost.rotation.dot(four)), 1e-9);
  EXPECT_LT(std::abs(lost.rotation.dot(five)), 1e-9);
  EXPECT_GT(lost.rotation.norm(), 0.01);
}

TEST(SpecialPosesTest, ASetContainsWhatHoldsThePoseAlongIt) {
  const Arm arm = make_arm(robot_of("puma560"), {});
  Eigen::VectorXd own(6), along(6);
  own << 0.3, 0.4, 0.5, 0.2, 0, 0.1;
  along << 0, 0, 0, 1, 0, -1;
  const ArmResult result =
      find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
  const auto set =
      std::find_if(result.moves.begin(), result.moves.end(),
                   [&](const SelfMotion& motion) { return contains(arm, result, motion, own); });
  ASSERT_NE(set, result.moves.end());
  EXPECT_TRUE(contains(arm, result, *set, own + 1.234 * along));
  EXPECT_TRUE(contains(arm, result, *set, own + 8 * along)) << "a turn more";
  // Beside a relation by less than postures of a set are told apart: the pose decides.
  const Eigen::VectorXd beside = own + 5e-6 * Eigen::VectorXd::Unit(6, 3);
  EXPECT_TRUE(is_on(arm, *set, beside, 1e-5));
  EXPECT_FALSE(contains(arm, result, *set, beside));
  EXPECT_TRUE(contains(arm, result, *set, beside, 1e-4));
  for (const ArmClosure& closure : result.closures) {
    EXPECT_FALSE(contains(arm, result, *set, closure.values)) << closure.id;
  }
  for (const SelfMotion& motion : result.moves) {
    EXPECT_LE(motion.values.cwiseAbs().maxCoeff(), std::numbers::pi);
    for (const JointRelation& relation : motion.relations) {
      EXPECT_LE(std::abs(relation.value), std::numbers::pi);
    }
  }
}

TEST(SpecialPosesTest, NearASingularPostureTheWeakestMotionIsTold) {
  const Arm arm = make_arm(robot_of("puma560"), {});
  Eigen::VectorXd own(6);
  own << 0.3, 0.4, 0.5, 0.2, 1e-4, 0.1;
  const ArmResult result =
      find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
  EXPECT_TRUE(result.complete);
  std::size_t near = 0;
  for (const ArmClosure& closure : result.closures) {
    EXPECT_NEAR(closure.weakest.joints.norm(), 1, 1e-12);
    // What the joints do at these velocities is the tip's weakest motion, as much slower as the
    // singular value says.
    const double dt = 1e-6;
    const Eigen::Isometry3d before =
        forward_kinematics(arm, closure.values - dt * closure.weakest.joints);
    const Eigen::Isometry3d after =
        forward_kinematics(arm, closure.values + dt * closure.weakest.joints);
    const double sigma = closure.smallest_singular_value;
    const Eigen::Vector3d moved = (after.translation() - before.translation()) / (2 * dt);
    EXPECT_LT((moved - sigma * closure.weakest.tip.translation).norm(), 1e-8);
    const Eigen::AngleAxisd turned(after.linear() * before.linear().transpose());
    EXPECT_LT(
        (turned.angle() / (2 * dt) * turned.axis() - sigma * closure.weakest.tip.rotation).norm(),
        1e-8);
    if (sigma > 1e-3) continue;
    ++near;
    EXPECT_NEAR(std::abs(closure.weakest.joints[3]), std::sqrt(0.5), 1e-3);
    EXPECT_NEAR(closure.weakest.joints[3] + closure.weakest.joints[5], 0, 1e-3);
  }
  EXPECT_EQ(near, 2U);
}

TEST(SpecialPosesTest, AStretchedArmIsFoundThoughItsClosuresMeet) {
  const Arm arm = arm_of("ur5", "tool0");
  Eigen::VectorXd own(6);
  own << 0.3, -1, 0, 0.7, 1.1, 0.4;  // the elbow is straight
  const ArmResult result =
      find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
  EXPECT_LT(least_distance(arm, result, own), 1e-4);
  EXPECT_LT(worst_miss(arm, result), 1e-10);
}

TEST(SpecialPosesTest, ASlideIsAJointLikeATurn) {
  const Robot robot = read_urdf(
      {"gantry",
       "<robot name='gantry'><link name='l0'/><link name='l1'/><link name='l2'/><link name='l3'/>"
       "<link name='l4'/><link name='l5'/><link name='l6'/>"
       "<joint name='x' type='prismatic'><parent link='l0'/><child link='l1'/>"
       "<axis xyz='1 0 0'/><limit lower='-1' upper='1'/></joint>"
       "<joint name='y' type='prismatic'><parent link='l1'/><child link='l2'/>"
       "<axis xyz='0 1 0'/><limit lower='-1' upper='1'/></joint>"
       "<joint name='a' type='continuous'><parent link='l2'/><child link='l3'/>"
       "<origin xyz='0 0 1'/><axis xyz='0 0 2'/></joint>"
       "<joint name='z' type='prismatic'><parent link='l3'/><child link='l4'/>"
       "<origin xyz='0.1 0 0'/><axis xyz='0 0.6 0.8'/><limit lower='-1' upper='1'/></joint>"
       "<joint name='b' type='continuous'><parent link='l4'/><child link='l5'/>"
       "<origin xyz='0 0.2 0.1'/><axis xyz='1 0 0'/></joint>"
       "<joint name='c' type='continuous'><parent link='l5'/><child link='l6'/>"
       "<origin xyz='0.1 0 0.2'/><axis xyz='0 0.3 1'/></joint></robot>"});
  const Arm arm = make_arm(robot, {});
  for (std::uint64_t k = 0; k < 5; ++k) {
    const Eigen::VectorXd own = random_values(arm, 8, k);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
    EXPECT_TRUE(result.complete);
    EXPECT_LT(least_distance(arm, result, own), 1e-9);
    EXPECT_LT(worst_miss(arm, result), 1e-10);
  }
}

TEST(SpecialPosesTest, FewJointsReachThePosesThatTheyCan) {
  for (std::size_t free = 1; free <= 5; ++free) {
    SCOPED_TRACE(free);
    Arm arm = arm_of(general_arm(2));
    arm.joints.resize(free);
    const Eigen::VectorXd own = random_values(arm, 5, free);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
    EXPECT_GE(result.counts.complex, 1U);
    EXPECT_LT(least_distance(arm, result, own), 1e-9);
    const ArmResult none =
        find_arm_closures(arm, pointing_down(0.123, 0.456, 0.789), lanes(), one_thread());
    EXPECT_TRUE(none.closures.empty()) << "so few joints cannot reach any pose";
    ASSERT_TRUE(none.nearest);
    const Eigen::Isometry3d there = forward_kinematics(arm, none.nearest->values);
    const PoseMisfit& apart = none.nearest->apart;
    EXPECT_NEAR(apart.position, (there.translation() - none.pose.translation()).norm(), 1e-12);
    const Eigen::AngleAxisd turned(
        Eigen::Matrix3d(there.linear().transpose() * none.pose.linear()));
    EXPECT_NEAR(apart.rotation, turned.angle(), 1e-9);
    EXPECT_NEAR(none.nearest->misfit, std::max(apart.position / arm.length, apart.rotation), 1e-9);
    EXPECT_NE(none.message.find(" m and "), std::string::npos) << none.message;
  }
}

/// A joint of a bare skeleton: its axis is z, its limits are a turn or an arm's length.
struct Link {
  std::string origin;
  bool is_slide = false;
};

Arm skeleton(const std::vector<Link>& links, const std::string& tool = "") {
  std::string text = "<robot name='skeleton'><link name='l0'/>";
  std::string last = "l0";
  for (std::size_t k = 1; k <= links.size(); ++k) {
    const Link& link = links[k - 1];
    const std::string n = std::to_string(k);
    text += "<link name='l" + n + "'/><joint name='j" + n + "' type='" +
            (link.is_slide ? "prismatic" : "revolute") + "'><parent link='" + last +
            "'/><child link='l" + n + "'/><origin " + link.origin +
            "/><axis xyz='0 0 1'/><limit lower='-3' upper='3' effort='1' velocity='1'/></joint>";
    last = "l" + n;
  }
  text += "<link name='tool'/><joint name='to' type='fixed'><parent link='" + last +
          "'/><child link='tool'/><origin " + tool + "/></joint></robot>";
  return make_arm(read_urdf({"skeleton", text}), {});
}

/// Turns about three parallel axes with a slide along them, as SCARA robots have them.
Arm scara() {
  return skeleton({{"xyz='0 0 0'"},
                   {"xyz='0.225 0 0.24'"},
                   {"xyz='0.175 0 0' rpy='3.141592653589793 0 0'", true},
                   {"xyz='0 0 0'"}});
}

TEST(SpecialPosesTest, AScaraHasTwoClosuresAndOneWhereItIsStretched) {
  const Arm arm = scara();
  for (std::uint64_t k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    Eigen::VectorXd own = random_values(arm, 8, k);
    const bool is_stretched = k % 5 == 4;
    if (is_stretched) own[1] = 0;
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_LE(result.paths.tracked, 8U);
    EXPECT_EQ(result.closures.size(), is_stretched ? 1U : 2U);
    EXPECT_LT(least_distance(arm, result, own), is_stretched ? 1e-6 : 1e-9);
    for (const ArmClosure& closure : result.closures) EXPECT_EQ(closure.singular, is_stretched);
    for (const LeftOut& left : result.left_out) EXPECT_EQ(left.what.find(", ,"), std::string::npos);
  }
}

/// A Dobot Magician's: a turn of the base, then three parallel axes.
Arm four_turns() {
  return skeleton({{"xyz='0 0 0'"},
                   {"xyz='0 0 0.138' rpy='1.5707963267948966 0 0'"},
                   {"xyz='0.135 0 0'"},
                   {"xyz='0.147 0 0'"}},
                  "xyz='0.06 0 0' rpy='1.5707963267948966 0 0'");
}

TEST(SpecialPosesTest, FourTurnsWithTheLastOneAboveTheBaseHaveTheirTwoClosures) {
  // There the arm stands regularly, and one with a wrist at its last joint would not.
  const Arm arm = four_turns();
  for (std::uint64_t k = 0; k < 16; ++k) {
    SCOPED_TRACE(k);
    Eigen::VectorXd own = random_values(arm, 13, k);
    // The second and the third link bring the last joint above the base.
    const double reach = 0.135 * std::cos(own[1]) / 0.147;
    own[2] = std::numbers::pi - own[1] - std::acos(reach) + (k % 2 == 0 ? 0 : 1e-7);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.closures.size(), 2U);
    EXPECT_LT(least_distance(arm, result, own), 1e-9);
  }
}

/// Three slides, then a wrist of z, y and z with a link between its axes.
Arm gantry() {
  std::string text = "<robot name='gantry'><link name='l0'/>";
  const char* const axes[] = {"1 0 0", "0 1 0", "0 0 1", "0 0 1", "0 1 0", "0 0 1"};
  for (int k = 1; k <= 6; ++k) {
    const std::string n = std::to_string(k);
    text += "<link name='l" + n + "'/><joint name='j" + n + "' type='" +
            (k <= 3 ? "prismatic" : "revolute") + "'><parent link='l" + std::to_string(k - 1) +
            "'/><child link='l" + n + "'/><origin xyz='0 0 " + (k <= 4 ? "0" : "-0.1") +
            "'/><axis xyz='" + axes[k - 1] +
            "'/><limit lower='-3' upper='3' effort='1' velocity='1'/></joint>";
  }
  return make_arm(read_urdf({"gantry", text + "</robot>"}), {});
}

/// Three slides and three turns without a common point, their right angles typed as 1.571.
Arm oblique_gantry() {
  return skeleton({{"rpy='0 0 0'", true},
                   {"rpy='1.571 0 1.571'", true},
                   {"rpy='1.571 0 1.571'", true},
                   {"rpy='0 0 0'"},
                   {"rpy='-1.571 0 0'"},
                   {"xyz='0 0.051 0' rpy='1.571 0 1.571'"}});
}

TEST(SpecialPosesTest, AGantryWithRoundedRightAnglesHasTheTwoClosuresOfItsTurns) {
  const Arm arm = oblique_gantry();
  for (std::uint64_t k = 0; k < 10; ++k) {
    SCOPED_TRACE(k);
    const Eigen::VectorXd own = random_values(arm, 14, k);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 2U);
    EXPECT_LT(least_distance(arm, result, own), 1e-9);
  }
}

TEST(SpecialPosesTest, PlacesOfASetThatIsThereWithinTheDigitsAreNoClosures) {
  // An Epson C4 typed to four decimals, its wrist straight but for 1e-6.
  const Arm arm = skeleton({{"xyz='0 0 0'"},
                            {"xyz='0.1 0 0.32' rpy='-1.5708 0 0'"},
                            {"xyz='0 -0.25 0' rpy='0 0 -1.5708'"},
                            {"xyz='0 0 0' rpy='-1.5708 0 0'"},
                            {"xyz='0 0 0.25' rpy='1.5708 0 0'"},
                            {"xyz='0 0 0' rpy='-1.5708 0 0'"}},
                           "xyz='0 0 0.065' rpy='0 0 3.1416'");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(0.41500000004551335, -2.3886353997042604e-07, 0.5700011569286886));
  pose.rotate(Eigen::Quaterniond(0.7071080797025057, 2.597249262078945e-06, 0.7071054826634349,
                                 -2.711689324710738e-10));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const ArmResult result = find_arm_closures(arm, pose, lanes(), one_thread(seed));
    EXPECT_EQ(result.closures.size(), 4U);
    for (const ArmClosure& closure : result.closures) EXPECT_LT(closure.residual, 2e-14);
    EXPECT_FALSE(result.moves.empty());
  }
}

TEST(SpecialPosesTest, PathsThatEndOnASetTellNothingButTheSet) {
  // At a straight wrist Newton's method contracts at any point of the set, complex ones too, which
  // have no conjugates.
  const Arm arm = gantry();
  for (std::uint64_t k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    Eigen::VectorXd own = random_values(arm, 12, k);
    own[4] = 0;
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.moves.size(), 1U);
    EXPECT_TRUE(result.closures.empty());
    EXPECT_EQ(result.counts.complex, 0U);
  }
}

TEST(SpecialPosesTest, WhereTheJacobianHasFullRankAClosureIsSimple) {
  const Arm arm = scara();
  for (std::uint64_t k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    const Eigen::VectorXd own = random_values(arm, 11, k);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
    EXPECT_EQ(result.counts.complex, 2U);
    for (const ArmClosure& closure : result.closures) {
      EXPECT_EQ(closure.multiplicity, 1U) << closure.smallest_singular_value;
    }
  }
}

}  // namespace
}  // namespace moivre::test
