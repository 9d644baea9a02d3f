// SPDX-License-Identifier: MIT
// Do people's own arms keep the posture that a pose was made from? Five joints, home poses, axes in
// line, angles typed to five digits;
// poses at singular postures and within 1e-9 to 1e-3 of them.
#include <gtest/gtest.h>

#include <iomanip>
#include <numbers>
#include <sstream>

#include "moivre/arms/poses.h"
#include "robots.h"
#if MOIVRE_WITH_CVODE
#include "moivre/tracker_cvode/cvode_tracker.h"
#endif

namespace moivre::test {
namespace {

struct PeoplesArm {
  const char* name;
  std::vector<HeldJoint> held;
  std::vector<std::vector<double>> values;  ///< that poses are made from
  bool moves = false;  ///< the tip can stand while the joints move, at every one of these poses
};

const std::vector<PeoplesArm>& peoples_arms() {
  static const std::vector<PeoplesArm> arms{
      {"adept_one_four_digits", {}, {{0, 0, 0, 0}, {0.3, 0, 0.1, -0.4}}, false},
      {"bravo7",
       {},
       {{1.028, 0.551, 0.253, 0.221, 1.257, 1.387}, {0.865, 1.436, 0.387, 1.433, 0.605, 0.75}},
       false},
      {"crx10ial",
       {},
       {{2.356194490192345, 0.0, -1.5707963267948966, 1.5707963267948966, 2.356194490192345,
         -2.356194490192345}},
       true},
      {"crx10ia_three_digits",
       {},
       {{-1.5707963268, 3.1415936536, 1.5707973268, -1.5707953268, 0, -1.5707962268}},
       false},
      {"elfin5",
       {},
       {{1.4415781224, 1.8892079798, 0.0252250007, -1.8308947962, 3.141592653589793, -0.840960168},
        {3.1415926546, 1.5717963268, 3.1416026536, 3.1416926536, 3.1415926546, 0}},
       true},
      {"fiveaxis",
       {},
       {{0.1, 0.2, 0.3, 0, 0.5},
        {0.1, 0.2, 0.3, 1e-09, 0.5},
        {0.1, 0.2, 0.3, 1e-06, 0.5},
        {0.1, 0.2, 0.3, -1e-06, -1.1},
        {0.1, 0.2, 0.3, 0.001, 0.5},
        {0.1, 0.2, 0.3, 3.141592653589793, 0.5},
        {0.1, 0.2, 0.3, 3.141591653589793, 0.5}},
       false},
      {"iiwa7_six_digits",
       {{"joint_3", 0.3}},
       {{3.1425926536, -1.5706963268, 3.1415926536, -1.5697963268, -1.5707963268, -1.5707953268}},
       false},
      {"iiwa14",
       {{"joint_a7", 2.721}},
       {{1.5799575184990262, 1.4893770988454786, -1.4313939433151546, -0.9970733816555748,
         0.20949707863316602, 1.8251363904224793}},
       false},
      {"m20ia",
       {},
       {{1.650741947, 1.2045614334, -1.285740796, 1.7505745137, 3.141592653589793, 1.3112157633}},
       true},
      {"m430ia2p", {}, {{0, 0, 0, 0, 0, 0}, {0.4, 0, 0, -0.4, 0, 0}}, true},
      {"pincher_arm",
       {},
       {{0.3002, 0.9533, 0.6616, -0.6595, -0.4796},
        {0.8965, -1.1874, 0.7709, 0.713, -0.077},
        {-0.4727, -0.5318, -0.5883, -0.1318, 0.0109},
        {0.1284, 1.1892, 0.7024, 0.2932, 1.1735},
        {-0.6833, -0.8155, 0.2701, -1.0945, -1.1144},
        {0.0357, -0.0811, 1.0012, 0.3101, 0.0339}},
       false},
      {"pincher_finger",
       {},
       {{0.3287, -0.5525, -1.1017, -1.1603, 0.7518},
        {0.9906, 0.2559, 0.5508, 0.1047, 1.0442},
        {0.758, -1.1934, 0.8578, -1.1194, 0.5512},
        {-0.7784, 0.8716, 0.0995, -0.4807, -0.1856},
        {-1.132, -0.9017, 0.4095, 0.3533, 0.2769}},
       false},
      {"px150", {}, {{0.3, -0.5, 0.4, 0.6, -0.3, 0.2}}, true},
      {"railed_6dof",
       {},
       {{-1.8701892318988271, -1.5707963267948966, -1.5707963267948966, 0.0, 1.5707963267948966,
         -1.5707963267948966}},
       false},
      {"schunk_lwa4p",
       {},
       {{-0.6114129202884033, -0.864836266284267, 0.07386111100500914, 0.0012484447909621998, 0.0,
         -0.31325917849104146}},
       false},
      {"sia20", {{"joint_2", 0.3}}, {{3e-10, -8e-10, 7e-10, -8e-10, -6e-10, 4e-10}}, true},
      {"so101",
       {},
       {{0.0236, 0.9009, -0.7117, 0.8973, -0.3763},
        {-0.1533, 0.6554, -0.1816, 0.0992, -0.9449},
        {0.507, 0.0763, -0.3405, 0.5769, -0.3936},
        {-0.093, -0.7319, -0.1938, -0.5931, -0.4754},
        {0.5007, -0.4392, -0.0296, 0.9615, 0.9233}},
       false},
      {"stanford", {}, {{0, 0, 0, 0, 0, 0}, {0.5, 0.8, 0, 0.4, 0.6, -0.3}}, true},
      {"tx2_90", {}, {{0, 0, 0, 0, 0, 0}, {0, 0, 0, 0.3, 0, -0.3}}, true},
      {"tx90",
       {},
       {{1.3848149455, 2.4377942563, 1.5707959964, 1.420266775, 2.0224936922, 2.4458808162}},
       false},
      {"ur10_six_digits", {}, {{1e-05, 1.5707973, 0.001, -1.5697963, 0, 1.5708963}}, true},
      {"ur30", {}, {{0, -3e-10, -5e-10, -4e-10, -8e-10, 7e-10}}, false},
      {"ur5_ros", {}, {{0.3, -1.0, 1.2, 0.4, 0, 0.7}, {0, 0, 0, 0, 0, 0}}, true},
      {"ur5_ros",
       {},
       {{0.3, -1.0, 1.2, 0.4, 1e-09, 0.7},
        {0.3, -1.0, 1.2, 0.4, 1e-07, 0.7},
        {0.3, -1.0, 1.2, 0.4, 1e-06, 0.7},
        {0.3, -1.0, 1.2, 0.4, 1e-05, 0.7}},
       false},
      {"ur5_six_digits",
       {},
       {{-3.062280276, 0.5865107472, -2.3426011024, 2.6509925784, 3.141592653589793,
         -0.9427030638}},
       false},
      {"wx250s_horn",
       {{"elbow", -0.55}},
       {{0.329, -0.553, -1.102, -1.16, 0.752, 0.991},
        {0.028, 1.081, -0.854, 1.077, -0.452, -0.184},
        {-0.572, -0.484, 0.754, -0.979, 0.24, 0.549}},
       true},
      {"yumi",
       {{"yumi_joint_3_r", -0.3}, {"yumi_joint_7_r", 0.4}},
       {{0.3, -0.5, 0.4, 0.6, -0.3, 0.01}},
       false},
      {"zu7_four_digits",
       {},
       {{-2.2399200506, -1.8255628377, -2.9287166493, 3.0359665499, 3.141592653589793,
         1.1265836799}},
       false},
  };
  return arms;
}

Arm made_of(const PeoplesArm& peoples) {
  const std::string file =
      std::string(MOIVRE_SOURCE_DIR "/tests/arms/people/") + peoples.name + ".urdf";
  return make_arm(read_urdf(read_source(file)), {std::nullopt, std::nullopt, peoples.held});
}

bool is_told(const Arm& arm, const ArmResult& result, const Eigen::VectorXd& own,
             double near = 1e-5) {
  if (least_distance(arm, result, own) < near) return true;
  return std::any_of(result.moves.begin(), result.moves.end(),
                     [&](const SelfMotion& set) { return is_on(arm, set, own, near); });
}

void expect_own_postures(const Tracker& tracker, std::uint64_t seed) {
  for (const PeoplesArm& peoples : peoples_arms()) {
    const Arm arm = made_of(peoples);
    for (const std::vector<double>& values : peoples.values) {
      SCOPED_TRACE(peoples.name + (" seed " + std::to_string(seed)));
      const Eigen::VectorXd own =
          Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
      const ArmResult result =
          find_arm_closures(arm, forward_kinematics(arm, own), tracker, one_thread(seed));
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_TRUE(is_told(arm, result, own)) << ::testing::PrintToString(values);
      const bool moves = std::any_of(result.moves.begin(), result.moves.end(),
                                     [](const SelfMotion& set) { return !set.within_digits; });
      EXPECT_EQ(moves, peoples.moves) << ::testing::PrintToString(values);
      for (const ArmClosure& closure : result.closures) {
        EXPECT_LE(closure.residual, closure.within_digits ? kReach + arm.rounding : kReach);
      }
    }
  }
}

TEST(PeoplesArmsTest, KeepThePostureThatAPoseWasMadeFrom) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) expect_own_postures(lanes(), seed);
}

/// Of a file's first pose.
struct Answer {
  Arm arm;
  Eigen::VectorXd own;
  ArmResult result;
};

Answer answer_of(const std::string& name) {
  const auto peoples = std::find_if(peoples_arms().begin(), peoples_arms().end(),
                                    [&](const PeoplesArm& one) { return one.name == name; });
  Answer answer{made_of(*peoples), {}, {}};
  answer.own =
      Eigen::Map<const Eigen::VectorXd>(peoples->values[0].data(), std::ssize(peoples->values[0]));
  answer.result = find_arm_closures(answer.arm, forward_kinematics(answer.arm, answer.own), lanes(),
                                    one_thread());
  return answer;
}

/// The m20ia's wrist is straight; closures of other sets are near.
TEST(PeoplesArmsTest, ASetHasNoMoreDimensionsThanItGoesOnIn) {
  const auto [arm, own, result] = answer_of("m20ia");
  ASSERT_FALSE(result.moves.empty());
  for (const SelfMotion& set : result.moves) {
    EXPECT_EQ(set.dimension, 1);
    EXPECT_FALSE(set.relations.empty()) << "joint_4 and joint_6 turn together";
  }
}

/// On the set within the digits two closures meet at the pose's own posture: the file's model has
/// it.
TEST(PeoplesArmsTest, ClosuresOnASetWithinTheDigitsAreListed) {
  const auto [arm, own, result] = answer_of("ur5_six_digits");
  ASSERT_FALSE(result.moves.empty());
  EXPECT_TRUE(result.moves.front().within_digits);
  EXPECT_LT(least_distance(arm, result, own), 1e-3);
}

/// Beside a stretched elbow the set of a straight wrist is a loop of a few thousandths of a radian.
TEST(PeoplesArmsTest, ASmallSetIsFollowed) {
  const auto [arm, own, result] = answer_of("ur10_six_digits");
  ASSERT_EQ(result.moves.size(), 1U);
  EXPECT_TRUE(result.moves[0].closes);
  EXPECT_EQ(result.moves[0].dimension, 1);
  EXPECT_LT(result.moves[0].misfit, 1e-14);
  EXPECT_TRUE(is_on(arm, result.moves[0], own, 1e-5));
  EXPECT_EQ(result.closures.size(), 2U);
}

/// Next to the stretched home pose a pair of closures is so nearly real that the pose is held
/// between them.
TEST(PeoplesArmsTest, APairThatIsNearlyRealIsAClosureWithinThePosesAccuracy) {
  const auto [arm, own, result] = answer_of("ur30");
  EXPECT_TRUE(result.complete);
  const auto between = std::find_if(result.closures.begin(), result.closures.end(),
                                    [&arm = arm, &own = own](const ArmClosure& closure) {
                                      return distance(arm, closure.values, own) > 1;
                                    });
  ASSERT_NE(between, result.closures.end());
  EXPECT_EQ(between->multiplicity, 2U);
  EXPECT_GT(between->residual, 1e-12);
  EXPECT_LE(between->residual, result.accuracy);
}

/// Seeds 1 to 5 list so many closures of the pose, and the posture that it was made from.
void expect_listed(const char* name, const Eigen::VectorXd& own, std::size_t count, double within) {
  const Arm arm = made_of({name, {}, {}});
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread(seed));
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.closures.size(), count);
    EXPECT_LT(least_distance(arm, result, own), within);
  }
}

/// Stretched, its two closures meet so flatly that rounding leaves a thousandth of a radian open,
/// and the accuracy of the pose a tenth.
TEST(PeoplesArmsTest, PlacesOfAFlatMeetingOfClosuresAreOfThem) {
  const Eigen::VectorXd own{{-1e-10, 6e-10, -6e-10, 6e-10, -1e-09, 2e-10}};
  expect_listed("tm12_three_digits", own, 3, 2e-3);
}

/// Folded, its wrist is 3e-7 from the shoulder's axis: on the last ten millionth of their way four
/// closures go far.
TEST(PeoplesArmsTest, PathsAreFollowedToTheirEndsBesideASet) {
  const auto [arm, own, result] = answer_of("tx90");
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.closures.size(), 8U);
  EXPECT_LT(least_distance(arm, result, own), 1e-7);
}

/// Stretched, its wrist on the shoulder's axis: closures are 1e-6 apart two by two, on a surface
/// that the digits make. They are there as typed, whatever the surface may explain.
TEST(PeoplesArmsTest, ClosuresOnASurfaceWithinTheDigitsAreListed) {
  const Eigen::VectorXd own{
      {0.4150931203, -2.4809975078, 1.6900918878, -1.550518959, 2.5418622791, -0.7340360497}};
  expect_listed("irb1200_three_digits", own, 4, 1e-5);
}

void expect_own_on_open_set(const PeoplesArm& peoples) {
  const Arm arm = made_of(peoples);
  const Eigen::VectorXd own = Eigen::Map<const Eigen::VectorXd>(peoples.values[0].data(), 6);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(peoples.name + (" seed " + std::to_string(seed)));
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread(seed));
    EXPECT_LT(least_distance(arm, result, own), 1e-6);
    EXPECT_TRUE(std::any_of(result.moves.begin(), result.moves.end(),
                            [](const SelfMotion& set) { return set.within_digits; }) ||
                !result.complete);
  }
}

/// The shoulder's axes meet but for 1.5708, and two of them are in line: closures that are far from
/// real at other poses are on that line. Paths lead to a pair beside them that is not real.
TEST(PeoplesArmsTest, ClosuresThatComeFromAfarToAStraightShoulderAreListed) {
  const std::vector<PeoplesArm> arms{
      {"panda_four_digits",
       {{"p7", 0.5}},
       {{-1.9439071987688485, 0, 0.40471769125890367, -0.09739601769578332, 2.505883621963318,
         -2.601160579096578}}},
      {"xarm7_four_digits",
       {{"x7", 0.5}},
       {{0.7249860371262926, 0, 3.124062163134476, 3.0211775357715274, 1.1657946707540434,
         0.9453635139748178}}}};
  for (const PeoplesArm& arm : arms) expect_own_on_open_set(arm);
}

/// The shoulder is straight, too, and the elbow nearly so: a second set crosses the first one, or
/// both are hidden in a region that all digits of the file leave open.
TEST(PeoplesArmsTest, ClosuresOnSetsThatCrossAreListed) {
  expect_own_on_open_set(
      {"xarm7_four_digits", {{"x6", 0.2}}, {{2.48091, 0, -1.00802, -0.43999, 2.46833, -2.68884}}});
  expect_own_on_open_set(
      {"xarm7_four_digits", {{"x7", 0.2}}, {{1.96186, 0, -0.41775, -3.04971, -1.44352, 1.66377}}});
  expect_own_on_open_set(
      {"panda_four_digits", {{"p5", 0.2}}, {{-2.38967, 0, 1.32168, -2.23054, 0.77934, 2.64139}}});
}

/// Two neighbouring axes are in line but for 1.5708: along the circles on which they turn against
/// each other the tip is missed by some 1e-12, which rounding tells from 0 here and there.
TEST(PeoplesArmsTest, CirclesThatMissThePoseByNextToNothingAreToldWhole) {
  const PeoplesArm peoples{"axes_in_line_four_digits",
                           {},
                           {{1.2399604308347145, 2.054570087267816, 1.5894377905915622,
                             0.08675271464642975, 1.156230526507522, 1.5857867478895464}}};
  const Arm arm = made_of(peoples);
  const Eigen::VectorXd own = Eigen::Map<const Eigen::VectorXd>(peoples.values[0].data(), 6);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread(seed));
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.moves.size(), 4U);
    std::size_t with_own = 0;
    for (const SelfMotion& circle : result.moves) {
      EXPECT_TRUE(circle.closes && !circle.within_digits);
      ASSERT_EQ(circle.relations.size(), 1U);
      EXPECT_EQ(circle.relations[0].factors, (Eigen::VectorXd{{0, 0, 1, -1, 0, 0}}));
      for (const Eigen::VectorXd& sample : circle.samples) {
        if (distance(arm, sample, own) < 0.1) {
          ++with_own;
          break;
        }
      }
    }
    EXPECT_EQ(with_own, 1U);
  }
}

TEST(PeoplesArmsTest, NoPostureWithAStraightShoulderIsLost) {
  constexpr std::uint64_t kPostures = 50;
  for (const PeoplesArm& peoples : {PeoplesArm{"panda_four_digits", {{"p6", 0.2}}, {}},
                                    PeoplesArm{"xarm7_four_digits", {{"x5", 0.2}}, {}}}) {
    const Arm arm = made_of(peoples);
    std::vector<Eigen::VectorXd> own;
    std::vector<Eigen::Isometry3d> poses;
    for (std::uint64_t k = 0; k < kPostures; ++k) {
      Eigen::VectorXd values(6);
      for (Eigen::Index i = 0; i < 6; ++i) {
        values[i] = 6.2 * random_unit(3, RandomStream::test, 6 * k + std::uint64_t(i)) - 3.1;
      }
      values[1] = 0;
      own.push_back(values);
      poses.push_back(forward_kinematics(arm, values));
    }
    const std::vector<ArmResult> results = find_arm_closures(arm, poses, lanes(), one_thread(1));
    std::uint64_t undecided = 0;
    for (std::uint64_t k = 0; k < kPostures; ++k) {
      SCOPED_TRACE(peoples.name + (" posture " + std::to_string(k)));
      if (!results[k].complete) ++undecided;
      // On such a set the accuracy of the pose lets closures be this far from where they are.
      EXPECT_TRUE(!results[k].complete || least_distance(arm, results[k], own[k]) < 0.05);
    }
    EXPECT_LE(undecided, kPostures / 10);
  }
}

/// Two closures are 1.2e-3 apart on a bent curve, along which Newton's steps miss the pose by more
/// before they miss it by less.
TEST(PeoplesArmsTest, ClosuresThatNearlyMeetOnABentCurveAreListed) {
  const auto [arm, own, result] = answer_of("crx10ia_three_digits");
  EXPECT_LT(least_distance(arm, result, own), 1e-4);
  EXPECT_EQ(result.closures.size(), 6U);
  for (const ArmClosure& closure : result.closures) EXPECT_LT(closure.residual, 1e-14);
}

#if MOIVRE_WITH_CVODE
TEST(PeoplesArmsTest, KeepItByTheOtherTrackerToo) {
  expect_own_postures(*make_cvode_tracker({}), 6);
}
#endif

/// At the first random pose that this seed draws eight paths need hundreds of digits, 7 s.
TEST(PeoplesArmsTest, ARegularPoseIsOneThatDoubleDecides) {
  const Arm arm = made_of({"bravo7", {}, {}});
  const Eigen::VectorXd own{{1.028, 0.551, 0.253, 0.221, 1.257, 1.387}};
  const ArmResult result =
      find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread(105));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 12U);
  EXPECT_EQ(result.paths.multiprecision, 0U);
}

/// Home, typed with three decimals. The accuracy leaves two freedoms open, round the curves of the
/// pose as it stands.
TEST(PeoplesArmsTest, ExactSetsOfACoarsePoseAreTold) {
  const Arm arm = made_of({"stanford", {}, {}});
  const TypedPose home = read_poses({"pose", "0 0.154 0.512 1 0 0 0"}).front();
  const Eigen::VectorXd own = Eigen::VectorXd::Zero(6);
  for (std::uint64_t seed = 101; seed <= 105; ++seed) {
    SCOPED_TRACE(seed);
    const ArmResult result = find_arm_closures(arm, home, lanes(), one_thread(seed));
    EXPECT_GT(result.accuracy, 1e-3);
    EXPECT_TRUE(is_told(arm, result, own));
    EXPECT_EQ(result.moves.size(), 4U) << "joints 2 and 5, joints 4 and 6; the arm turned over";
    for (const SelfMotion& set : result.moves) {
      EXPECT_EQ(set.dimension, 1);
      EXPECT_LT(set.misfit, 1e-12);
      EXPECT_EQ(set.relations.size(), 1U);
    }
  }
}

/// Of all that is told the nearest posture, closure or sample of a set, is no farther.
bool is_shown(const Arm& arm, const ArmResult& result, const Eigen::VectorXd& own, double within) {
  const auto is_near = [&](const Eigen::VectorXd& values) {
    return distance(arm, values, own) < within;
  };
  return std::any_of(result.closures.begin(), result.closures.end(),
                     [&](const ArmClosure& closure) { return is_near(closure.values); }) ||
         std::any_of(result.moves.begin(), result.moves.end(), [&](const SelfMotion& set) {
           return std::any_of(set.samples.begin(), set.samples.end(), is_near);
         });
}

/// One pose of a list: more searches from random postures would often find the posture.
void expect_shown(const PeoplesArm& peoples, const TypedPose& pose) {
  const Arm arm = made_of(peoples);
  const Eigen::VectorXd own =
      Eigen::Map<const Eigen::VectorXd>(peoples.values[0].data(), std::ssize(peoples.values[0]));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(peoples.name + (" seed " + std::to_string(seed)));
    const ArmResult result =
        find_arm_closures(arm, std::vector{pose}, lanes(), one_thread(seed)).front();
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(is_shown(arm, result, own, 0.5));
  }
}

/// Next to home, typed with four decimals and out of reach by less than that: what holds the pose
/// is a net on a torus, in two of three turns whose sum is told.
TEST(PeoplesArmsTest, WhatTheAccuracyLeavesOpenIsToldWhole) {
  expect_shown(
      {"iiwa14_three_digits",
       {{"joint_1", 0.3}},
       {{0.000224095, 0.0007111661, -0.000790719, 0.0004067479, 0.000813103, 0.0007866197}}},
      read_poses({"pose", "0.0007 0.0002 1.306 0.9886 -0.0001 0.0009 0.1504"}).front());
}

/// Home: its closures are a quarter turn from it, at corners of what the accuracy leaves open, and
/// what moves the tip least there leads out of it.
TEST(PeoplesArmsTest, WhatIsOpenIsFollowedFromItsCorners) {
  expect_shown({"sia20_all_digits", {{"joint_2", 0.3}}, {{0, 0, 0, 0, 0, 0}}},
               read_poses({"pose", "0.3221 0 1.4513 -0.9888 0 -0.1494 0"}).front());
}

/// Home: three axes are in line but for the pose's rounding. Paths slide into complex numbers along
/// the plane on which their turns have one sum, as far as rounding lets them be followed.
TEST(PeoplesArmsTest, PathsAlongAPlaneThatIsOpenAreOfIt) {
  expect_shown({"panda_all_digits", {{"joint_7", 0.3}}, {{0, 0, 0, 0, 0, 0}}},
               read_poses({"pose", "0.088 0 0.926 0 -0.9888 0.1494 0"}).front());
}

/// Home: paths slide along a surface that the pose's rounding leaves open, until two turns are
/// nearly infinite, with opposite signs.
TEST(PeoplesArmsTest, PathsFarFromRealAreOfTheSurfaceThatLeadsThere) {
  expect_shown({"elfin5_six_digits", {}, {{0, 0, 0, 0, 0, 0}}},
               read_poses({"pose", "0 0 1.2 0.0000 0.0000 0.0000 1.0000"}).front());
}

/// Home but for 1e-9: three axes are in line to 1e-10, and along curves of two turns the tip stands
/// to rounding. Around one walks to all sides end on it again: it is no surface, and the one where
/// the wrist is turned over is another.
TEST(PeoplesArmsTest, ASetAllOfWhosePlacesAreOnALineIsACurve) {
  const Arm arm = made_of({"pr2_four_digits", {{"joint_1", 0.3}}, {}});
  const std::string pose =
      "0.9562928036479172 0.29581256511147147 -3.3086216372764364e-06 0.6991658386252625 "
      "-0.10566891048216376 0.6991680180106641 0.10566595500910562";
  constexpr double kTurn = 1.66;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const ArmResult result =
        find_arm_closures(arm, read_poses({"poses", pose}), lanes(), one_thread(seed)).front();
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(is_told(arm, result, Eigen::VectorXd{{0, kTurn, 0, -kTurn, 0, 0}}, 1e-3));
    for (const SelfMotion& set : result.moves) {
      EXPECT_EQ(set.relations.size(), 1U) << "some turns have one sum";
    }
  }
}

/// One pose of a list, as it was printed: what holds it is on a set that is told.
void expect_on_a_set(const PeoplesArm& peoples, const std::string& pose) {
  const Arm arm = made_of(peoples);
  const std::vector<double>& values = peoples.values[0];
  const Eigen::VectorXd own = Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(peoples.name + (" seed " + std::to_string(seed)));
    const ArmResult result =
        find_arm_closures(arm, read_poses({"poses", pose}), lanes(), one_thread(seed)).front();
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(std::any_of(result.moves.begin(), result.moves.end(), [&](const SelfMotion& set) {
      return !set.within_digits && is_on(arm, set, own, 1e-3);
    }));
  }
}

/// Elbow and wrist are folded but for 1e-6 to 1e-5: two turns go together along loops that are seen
/// as curves with short steps only, and are as long as others.
TEST(PeoplesArmsTest, ACurveThatBeginsWithShortStepsIsFollowedToItsEnd) {
  expect_on_a_set(
      {"iiwa7_all_digits",
       {{"joint_3", 0.3}},
       {{1.5708963268, -1.5707963268, 3.1416026536, 3.1425926536, 3.1415936536, -1.5707963268}}},
      "1.1827389772939356e-05 -0.12599999945963802 0.34000249721240716 0.10535466367832465 "
      "0.10528357622824527 0.6992285914311589 -0.6992103691615391");
}

/// The shoulder is straight and the elbow nearly: along a curve two turns have one sum, as typed,
/// and it is on a surface that the file's digits leave open.
TEST(PeoplesArmsTest, AnExactSetIsToldWithinOneOfTheDigits) {
  expect_on_a_set({"panda_with_tool_four_digits",
                   {{"joint_7", 0.3}},
                   {{1.5707973268, 0, 0.7853991634, 0.001, 1e-07, 3.1415926536}}},
                  "0.06257265675923233 -0.06257239491102055 1.1398292545284383 0.9706929892665611 "
                  "0.00025822415343626607 0.000428159159361563 -0.24032243047366228");
}

/// Of five joints: searches lead to places of the told set, each of which misses the pose least
/// next to itself.
TEST(PeoplesArmsTest, PlacesOfAnOpenSetAreNoneThatPathsMissed) {
  expect_shown({"nao_six_digits", {}, {{0, 0, 0, 0, 0}}},
               read_poses({"pose", "0.2187 0.0 -0.015 -0.7071 0 -0.7071 0"}).front());
}

/// Next to home shoulder, elbow and wrist are straight but for so little that a curve holds the
/// pose as far as its accuracy tells. It is no plane's, and paths stop on its continuation into
/// complex numbers.
TEST(PeoplesArmsTest, PathsAlongACurveThatIsBentAreOfIt) {
  for (const char* const held : {"joint_2", "joint_6"}) {
    SCOPED_TRACE(held);
    const Arm arm = made_of({"iiwa14_all_digits", {{held, 0.3}}, {}});
    std::vector<TypedPose> poses;
    std::vector<Eigen::VectorXd> own;
    for (std::uint64_t index = 0; index < 4; ++index) {
      own.push_back(1e-6 * random_values(arm, 5, index));
      poses.push_back({forward_kinematics(arm, own.back())});
    }
    const std::vector<ArmResult> results = find_arm_closures(arm, poses, lanes(), one_thread());
    for (std::size_t k = 0; k < results.size(); ++k) {
      EXPECT_TRUE(results[k].complete) << k << ": " << results[k].message;
      EXPECT_TRUE(is_told(arm, results[k], own[k], 1e-3)) << k;
    }
  }
}

/// Next to home, joint 2 held: joints 3, 5 and 7 turn along two loops, within a tenth of the
/// digits, while the others hardly move. Within less the loops are in pieces.
TEST(PeoplesArmsTest, LoopsAreToldOfWhichPiecesAreWithinLess) {
  const Arm arm = made_of({"pr2_six_digits", {{"joint_2", 0.3}}, {}});
  const Eigen::VectorXd own{
      {5.3578e-06, 4.0841e-06, 3.6022e-06, -7.672e-07, -8.9579e-06, 3.6626e-06}};
  const std::vector poses{TypedPose{forward_kinematics(arm, own)}};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const ArmResult result = find_arm_closures(arm, poses, lanes(), one_thread(seed)).front();
    EXPECT_TRUE(result.complete) << result.message;
    const auto loops =
        std::count_if(result.moves.begin(), result.moves.end(),
                      [](const SelfMotion& set) { return set.dimension == 1 && set.closes; });
    EXPECT_EQ(loops, 2);
  }
}

/// Nearly stretched a SCARA whose tool is turned by 3.1416 holds its pose as typed in one posture,
/// and within the digits in a second one, which searches may come to first.
TEST(PeoplesArmsTest, OfPlacesThatRoundingMergesTheOneAsTypedIsTold) {
  const Arm arm = made_of({"adept_one_four_digits", {}, {}});
  const Eigen::VectorXd own{{2.7335992829, -0.0001750138, 0.7297126257, -1.3349943805}};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread(seed));
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(is_told(arm, result, own));
  }
}

/// As a file of poses with so many decimals has it.
TypedPose rounded_pose(const Eigen::Isometry3d& tip, int decimals) {
  const Eigen::Quaterniond turn(tip.linear());
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals);
  for (const double x : tip.translation()) text << x << ' ';
  text << turn.w() << ' ' << turn.x() << ' ' << turn.y() << ' ' << turn.z();
  return read_poses({"pose", text.str()}).front();
}

/// Its elbow is stretched: rounded to three decimals the pose may be out of reach.
TEST(PeoplesArmsTest, APoseRoundedOutOfReachIsHeldWithinItsAccuracy) {
  const Arm arm = arm_of(DenavitHartenberg{
      {0, 0.425, 0.392, 0, 0, 0}, {0.089, 0, 0, 0.109, 0.095, 0.08}, {90, 0, 0, 90, -90, 0}});
  constexpr double kNear = 0.15;
  std::size_t out_of_reach = 0;
  for (std::uint64_t index = 0; index < 20; ++index) {
    SCOPED_TRACE(index);
    Eigen::VectorXd own = random_values(arm, 3, index);
    own[2] = 0;
    const TypedPose rounded = rounded_pose(forward_kinematics(arm, own), 3);
    const ArmResult result = find_arm_closures(arm, rounded, lanes(), one_thread());
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(is_shown(arm, result, own, kNear));
    out_of_reach += std::none_of(
        result.closures.begin(), result.closures.end(), [&](const ArmClosure& closure) {
          return closure.residual < 1e-9 && distance(arm, closure.values, own) < kNear;
        });
  }
  EXPECT_GT(out_of_reach, 3U);
}

/// Typed with 1.5708 a wrist cannot be quite straight: where the pose asks it to, the joints on
/// either side of it are infinitely far from real, and the pose is held within its accuracy.
TEST(PeoplesArmsTest, AWristThatMissesAStraightOneByTheDigitsIsTold) {
  const Arm arm = made_of({"kawasaki_four_digits", {}, {}});
  constexpr double kHalf = std::numbers::pi;
  const Eigen::VectorXd own{{kHalf / 2, kHalf / 2, kHalf, kHalf / 4, kHalf, kHalf / 2}};
  const TypedPose rounded = rounded_pose(forward_kinematics(arm, own), 4);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    // As one of a list: more searches from random postures would often find it.
    const ArmResult result =
        find_arm_closures(arm, std::vector{rounded}, lanes(), one_thread(seed)).front();
    EXPECT_TRUE(is_told(arm, result, own, 1e-3)) << result.message;
  }
}

/// Next to home three axes are nearly in line. Two of them are along each of two curves, which come
/// within 1e-7 of each other.
TEST(PeoplesArmsTest, CurvesThatNearlyMeetAreAllTold) {
  const Arm arm = made_of({"iiwa14_all_digits", {{"joint_1", 0.3}}, {}});
  constexpr Eigen::Index kUpperArm = 1, kForearm = 3, kWrist = 5;
  constexpr double kTurn = 0.8;
  for (std::uint64_t index = 0; index < 8; ++index) {
    SCOPED_TRACE(index);
    const Eigen::VectorXd own = 1e-7 * random_values(arm, 3, index);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
    EXPECT_TRUE(result.complete) << result.message;
    for (const Eigen::Index other : {kUpperArm, kWrist}) {
      Eigen::VectorXd turned = own;
      turned[kForearm] += kTurn;
      turned[other] -= kTurn;
      EXPECT_TRUE(is_told(arm, result, turned, 1e-3)) << other;
    }
  }
}

/// The elbow is stretched and the wrist straight but for 1e-6: two turns have one sum along each of
/// two loops, the wrist turned over. Curves that hold the pose to 1e-12 and end cross both, and all
/// paths may stop at one of these.
TEST(PeoplesArmsTest, CurvesThatCrossPiecesAreAllTold) {
  const Arm arm = made_of({"sia20_all_digits", {{"joint_2", 0.3}}, {}});
  constexpr double kHalf = std::numbers::pi;
  const Eigen::VectorXd own{
      {-kHalf / 2 + 1e-9, kHalf / 2 + 1e-3, 0, kHalf / 2 + 1e-7, kHalf + 1e-6, kHalf}};
  Eigen::VectorXd turned_over = own;
  turned_over[3] += kHalf;
  turned_over[4] = -own[4];
  turned_over[5] += kHalf;
  const std::vector poses{TypedPose{forward_kinematics(arm, own)}};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const ArmResult result = find_arm_closures(arm, poses, lanes(), one_thread(seed)).front();
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(is_told(arm, result, own));
    EXPECT_TRUE(is_told(arm, result, turned_over));
    const auto loops = std::count_if(result.moves.begin(), result.moves.end(),
                                     [](const SelfMotion& set) { return set.closes; });
    EXPECT_EQ(loops, 2);
    EXPECT_TRUE(result.closures.empty()) << "places of the pieces";
  }
}

/// As before, shoulder and wrist. Only what the formula proposes leads to where its loop crosses.
TEST(PeoplesArmsTest, WhereNoPathComesNearTheFormulaLeads) {
  const Arm arm = made_of({"iiwa14_all_digits", {{"joint_6", 0.3}}, {}});
  constexpr double kHalf = std::numbers::pi;
  const Eigen::VectorXd own{{kHalf, kHalf, -0.4058885539, 1e-6, -0.1160295988, -0.1188287285}};
  const std::vector poses{TypedPose{forward_kinematics(arm, own)}};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const ArmResult result = find_arm_closures(arm, poses, lanes(), one_thread(seed)).front();
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(is_told(arm, result, own));
  }
}

/// The upper arm and the forearm are as long: folded, joint 2 turns the arm while joint 5 keeps the
/// tool, and where that makes the wrist straight joints 4 and 6 move, too. Random searches come to
/// the second kind of curve by luck.
TEST(PeoplesArmsTest, CurvesThatCrossAreAllTold) {
  const Arm arm = made_of({"epson_c4_all_digits", {}, {}});
  constexpr double kQuarter = std::numbers::pi / 2;
  const Eigen::VectorXd own{{kQuarter / 2, kQuarter / 2, kQuarter, 0, kQuarter / 2, kQuarter / 2}};
  const std::vector poses{TypedPose{forward_kinematics(arm, own)}};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const ArmResult result = find_arm_closures(arm, poses, lanes(), one_thread(seed)).front();
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.closures.size(), 4U) << "the arm turned over";
    ASSERT_EQ(result.moves.size(), 4U);
    for (const SelfMotion& set : result.moves) {
      EXPECT_EQ(set.relations.size(), 1U);
      EXPECT_EQ((set.directions.array().abs() > 0).count(), 2) << "of two joints";
    }
  }
}

}  // namespace
}  // namespace moivre::test
