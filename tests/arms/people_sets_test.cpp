// SPDX-License-Identifier: MIT
// Are the sets told along which the joints of people's own arms move while the tip stands, each to
// its ends, and no others?
#include <gtest/gtest.h>

#include <numbers>

#include "people_arms.h"

namespace moivre::test {
namespace {

/// The m20ia's wrist is straight; closures of other sets are near.
TEST(PeoplesSetsTest, ASetHasNoMoreDimensionsThanItGoesOnIn) {
  const auto [arm, own, result] = answer_of("m20ia");
  ASSERT_FALSE(result.moves.empty());
  for (const SelfMotion& set : result.moves) {
    EXPECT_EQ(set.dimension, 1);
    EXPECT_FALSE(set.relations.empty()) << "joint_4 and joint_6 turn together";
  }
}

/// Beside a stretched elbow the set of a straight wrist is a loop of a few thousandths of a radian.
TEST(PeoplesSetsTest, ASmallSetIsFollowed) {
  const auto [arm, own, result] = answer_of("ur10_six_digits");
  ASSERT_EQ(result.moves.size(), 1U);
  EXPECT_TRUE(result.moves[0].closes);
  EXPECT_EQ(result.moves[0].dimension, 1);
  EXPECT_LT(result.moves[0].misfit, 1e-14);
  EXPECT_TRUE(is_on(arm, result.moves[0], own, 1e-5));
  EXPECT_EQ(result.closures.size(), 2U);
}

/// Two neighbouring axes are in line but for 1.5708: along the circles on which they turn against
/// each other the tip is missed by some 1e-12, which rounding tells from 0 here and there.
TEST(PeoplesSetsTest, CirclesThatMissThePoseByNextToNothingAreToldWhole) {
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

/// Home, typed with three decimals. The accuracy leaves two freedoms open, round the curves of the
/// pose as it stands.
TEST(PeoplesSetsTest, ExactSetsOfACoarsePoseAreTold) {
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

/// Next to home, typed with four decimals and out of reach by less than that: what holds the pose
/// is a net on a torus, in two of three turns whose sum is told.
TEST(PeoplesSetsTest, WhatTheAccuracyLeavesOpenIsToldWhole) {
  expect_shown(
      {"iiwa14_three_digits",
       {{"joint_1", 0.3}},
       {{0.000224095, 0.0007111661, -0.000790719, 0.0004067479, 0.000813103, 0.0007866197}}},
      read_poses({"pose", "0.0007 0.0002 1.306 0.9886 -0.0001 0.0009 0.1504"}).front());
}

/// Home: its closures are a quarter turn from it, at corners of what the accuracy leaves open, and
/// what moves the tip least there leads out of it.
TEST(PeoplesSetsTest, WhatIsOpenIsFollowedFromItsCorners) {
  expect_shown({"sia20_all_digits", {{"joint_2", 0.3}}, {{0, 0, 0, 0, 0, 0}}},
               read_poses({"pose", "0.3221 0 1.4513 -0.9888 0 -0.1494 0"}).front());
}

/// Home: three axes are in line but for the pose's rounding. Paths slide into complex numbers along
/// the plane on which their turns have one sum, as far as rounding lets them be followed.
TEST(PeoplesSetsTest, PathsAlongAPlaneThatIsOpenAreOfIt) {
  expect_shown({"panda_all_digits", {{"joint_7", 0.3}}, {{0, 0, 0, 0, 0, 0}}},
               read_poses({"pose", "0.088 0 0.926 0 -0.9888 0.1494 0"}).front());
}

/// Home: paths slide along a surface that the pose's rounding leaves open, until two turns are
/// nearly infinite, with opposite signs.
TEST(PeoplesSetsTest, PathsFarFromRealAreOfTheSurfaceThatLeadsThere) {
  expect_shown({"elfin5_six_digits", {}, {{0, 0, 0, 0, 0, 0}}},
               read_poses({"pose", "0 0 1.2 0.0000 0.0000 0.0000 1.0000"}).front());
}

/// Home but for 1e-9: three axes are in line to 1e-10, and along curves of two turns the tip stands
/// to rounding. Around one walks to all sides end on it again: it is no surface, and the one where
/// the wrist is turned over is another.
TEST(PeoplesSetsTest, ASetAllOfWhosePlacesAreOnALineIsACurve) {
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
  const Eigen::VectorXd own = own_of(peoples);
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
TEST(PeoplesSetsTest, ACurveThatBeginsWithShortStepsIsFollowedToItsEnd) {
  expect_on_a_set(
      {"iiwa7_all_digits",
       {{"joint_3", 0.3}},
       {{1.5708963268, -1.5707963268, 3.1416026536, 3.1425926536, 3.1415936536, -1.5707963268}}},
      "1.1827389772939356e-05 -0.12599999945963802 0.34000249721240716 0.10535466367832465 "
      "0.10528357622824527 0.6992285914311589 -0.6992103691615391");
}

/// The shoulder is straight and the elbow nearly: along a curve two turns have one sum, as typed,
/// and it is on a surface that the file's digits leave open.
TEST(PeoplesSetsTest, AnExactSetIsToldWithinOneOfTheDigits) {
  expect_on_a_set({"panda_with_tool_four_digits",
                   {{"joint_7", 0.3}},
                   {{1.5707973268, 0, 0.7853991634, 0.001, 1e-07, 3.1415926536}}},
                  "0.06257265675923233 -0.06257239491102055 1.1398292545284383 0.9706929892665611 "
                  "0.00025822415343626607 0.000428159159361563 -0.24032243047366228");
}

/// Of five joints: searches lead to places of the told set, each of which misses the pose least
/// next to itself.
TEST(PeoplesSetsTest, PlacesOfAnOpenSetAreNoneThatPathsMissed) {
  expect_shown({"nao_six_digits", {}, {{0, 0, 0, 0, 0}}},
               read_poses({"pose", "0.2187 0.0 -0.015 -0.7071 0 -0.7071 0"}).front());
}

/// Next to home shoulder, elbow and wrist are straight but for so little that a curve holds the
/// pose as far as its accuracy tells. It is no plane's, and paths stop on its continuation into
/// complex numbers.
TEST(PeoplesSetsTest, PathsAlongACurveThatIsBentAreOfIt) {
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
TEST(PeoplesSetsTest, LoopsAreToldOfWhichPiecesAreWithinLess) {
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

/// Postures of quarter turns, rounded to five and eight decimals: curves that hold the pose to
/// 1e-10 lead to closures from which they are found again.
TEST(PeoplesSetsTest, ACurveThatLeadsToItsOwnClosuresIsToldOnce) {
  const Arm ur5 = arm_of("ur5", "tool0");
  const Arm kinova = arm_of("kinova_j2s6s200", "j2s6s200_end_effector");
  const std::pair<const Arm*, const char*> poses[]{
      {&ur5, "-0.67780 0.19145 0.31655 0.45402 -0.45402 0.54209 0.54209"},
      {&ur5, "-0.67780 0.19145 0.31655 0.45400 -0.45400 0.54210 0.54210"},
      {&ur5, "-0.67781 0.19145 0.31655 0.45402 -0.45402 0.54209 0.54209"},
      {&ur5, "-0.09465 0.19145 -0.72809 -0.23064 0.23064 0.66843 0.66843"},
      {&kinova, "0.00980000 0 -0.08720000 0.70638442 -0.03195379 0.70638442 0.03195379"}};
  for (const auto& [arm, text] : poses) {
    SCOPED_TRACE(text);
    const TypedPose pose = read_poses({"pose", text}).front();
    const ArmResult result = find_arm_closures(*arm, pose, lanes(), one_thread());
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_FALSE(result.moves.empty());
    EXPECT_LE(result.moves.size(), 3U);
    const auto curves =
        std::count_if(result.moves.begin(), result.moves.end(),
                      [](const SelfMotion& set) { return set.dimension == 1 && set.closes; });
    EXPECT_GE(curves, 1);
  }
}

/// Typed with 1.5708 a wrist cannot be quite straight: where the pose asks it to, the joints on
/// either side of it are infinitely far from real, and the pose is held within its accuracy.
TEST(PeoplesSetsTest, AWristThatMissesAStraightOneByTheDigitsIsTold) {
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
TEST(PeoplesSetsTest, CurvesThatNearlyMeetAreAllTold) {
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
TEST(PeoplesSetsTest, CurvesThatCrossPiecesAreAllTold) {
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

/// The upper arm and the forearm are as long: folded, joint 2 turns the arm while joint 5 keeps the
/// tool, and where that makes the wrist straight joints 4 and 6 move, too. Random searches come to
/// the second kind of curve by luck.
TEST(PeoplesSetsTest, CurvesThatCrossAreAllTold) {
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
