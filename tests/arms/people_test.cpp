// SPDX-License-Identifier: MIT
// Do people's own arms keep the posture that a pose was made from, and all closures beside it?
#include <gtest/gtest.h>

#include <numbers>

#include "people_arms.h"
#if MOIVRE_WITH_CVODE
#include "moivre/tracker_cvode/cvode_tracker.h"
#endif

namespace moivre::test {
namespace {

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

/// On the set within the digits two closures meet at the pose's own posture: the file's model has
/// it.
TEST(PeoplesArmsTest, ClosuresOnASetWithinTheDigitsAreListed) {
  const auto [arm, own, result] = answer_of("ur5_six_digits");
  ASSERT_FALSE(result.moves.empty());
  EXPECT_TRUE(result.moves.front().within_digits);
  EXPECT_LT(least_distance(arm, result, own), 1e-3);
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

/// Eight closures of this one are so far from real at other poses that no path begins at them.
TEST(PeoplesArmsTest, ClosuresOfACalibratedArmThatAreFarFromRealElsewhereAreListed) {
  const Eigen::VectorXd own{
      {1.5717963268, 0.7853991634, 0.7853982634, 3.1415926536, 0, -1.5707962268}};
  expect_listed("m10ia_calibrated", own, 8, 1e-9);
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

/// The shoulder is turned over and the elbow stretched but for 1e-6: the loop on which the posture
/// stands is crossed by another one. Only what the formula proposes leads to where they cross.
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

}  // namespace
}  // namespace moivre::test
