// SPDX-License-Identifier: MIT
// Are published inverse kinematics found, whatever the seed and the tracker?
#include <gtest/gtest.h>

#include "robots.h"
#if MOIVRE_WITH_CVODE
#include "moivre/tracker_cvode/cvode_tracker.h"
#endif

namespace moivre::test {
namespace {

Eigen::Isometry3d pose_of(const std::array<double, 12>& rows) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      pose(i, j) = rows[static_cast<std::size_t>(4 * i + j)];
    }
  }
  return pose;
}

Eigen::VectorXd degrees(const std::array<double, 6>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), 6) * std::numbers::pi / 180;
}

/// The Puma at 20, -30, 50, -140, -60, 110 degrees: eight postures [Pieper68].
const std::array<double, 12> kPumaPose{
    0.7624523637705527,   -0.3307627214284456, -0.5561136710187455, 0.28186546747901,
    -0.37155669922007917, 0.47982339505876886, -0.7948050885713782, -0.05708923453012271,
    0.5297282437678554,   0.8126287785129968,  0.24294537675596625, 0.1968022825648664};

TEST(ArmClosuresTest, ThePumaHasEightPosturesForEverySeed) {
  const Arm arm = make_arm(robot_of("puma560"), {});
  const std::array<std::array<double, 6>, 8> known{
      {{20, -30, 50, -140, -60, 110},
       {20, -30, 50, 40, 60, -70},
       {20, 107.4702, 135.38327, -75.27659, -144.86045, -119.42491},
       {20, 107.4702, 135.38327, 104.72341, 144.86045, 60.57509},
       {137.10033, -150, 135.38327, -78.77712, 78.38386, -71.68461},
       {137.10033, -150, 135.38327, 101.22288, -78.38386, 108.31539},
       {137.10033, 72.5298, 50, -106.06619, 91.02866, 66.46194},
       {137.10033, 72.5298, 50, 73.93381, -91.02866, -113.53806}}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ArmResult result = find_arm_closures(arm, pose_of(kPumaPose), lanes(), one_thread(seed));
    ASSERT_EQ(result.counts.complex, 8U) << "seed " << seed;
    ASSERT_EQ(result.counts.real, 8U) << "seed " << seed;
    EXPECT_LE(result.paths.tracked, 6U);
    for (const auto& posture : known) {
      EXPECT_LT(least_distance(arm, result, degrees(posture)), 1e-6) << "seed " << seed;
    }
    EXPECT_LT(least_distance(arm, result, degrees(known[0])), 1e-9);
  }
}

// Joint values of one of the sixteen real closures [ManseurDoty89].
TEST(ArmClosuresTest, ManseurAndDotysArmHasSixteenRealClosuresForEverySeed) {
  const Arm arm = arm_of(kManseurDoty);
  const Eigen::VectorXd own =
      degrees({-178.12618802173367, 108.19164996318042, 32.26616636776806, -174.3067510208961,
               -15.325436904538437, -0.4194928383216727});
  const Eigen::Isometry3d pose = forward_kinematics(arm, own);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ArmResult result = find_arm_closures(arm, pose, lanes(), one_thread(seed));
    ASSERT_EQ(result.counts.complex, 16U) << "seed " << seed;
    ASSERT_EQ(result.counts.real, 16U) << "seed " << seed;
    EXPECT_LE(result.paths.tracked, 24U);
    EXPECT_LT(least_distance(arm, result, own), 1e-9);
  }
}

// [RaghavanRoth93]
TEST(ArmClosuresTest, AGeneralArmHasSixteenComplexClosures) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Arm arm = arm_of(general_arm(seed));
    const Eigen::VectorXd own = random_values(arm, seed, 0);
    const ArmResult result =
        find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread(seed));
    EXPECT_EQ(result.counts.complex, 16U);
    EXPECT_EQ(result.counts.rejected, 8U);
    EXPECT_LT(least_distance(arm, result, own), 1e-9);
  }
}

#if MOIVRE_WITH_CVODE
TEST(ArmClosuresTest, BothTrackersFindTheSameClosures) {
  const auto cvode = make_cvode_tracker({});
  const Arm arm = arm_of(general_arm(3));
  const Eigen::Isometry3d pose = forward_kinematics(arm, random_values(arm, 3, 1));
  const ArmResult a = find_arm_closures(arm, pose, lanes(), one_thread());
  const ArmResult b = find_arm_closures(arm, pose, *cvode, one_thread());
  EXPECT_EQ(b.counts.complex, 16U);
  ASSERT_EQ(a.closures.size(), b.closures.size());
  for (std::size_t k = 0; k < a.closures.size(); ++k) {
    EXPECT_LT(distance(arm, a.closures[k].values, b.closures[k].values), 1e-9);
  }
}
#endif

TEST(ArmClosuresTest, ClosuresHaveTheSameNamesForEverySeed) {
  const Arm arm = arm_of("ur5", "tool0");
  const Eigen::Isometry3d pose = forward_kinematics(arm, random_values(arm, 5, 2));
  const ArmResult a = find_arm_closures(arm, pose, lanes(), one_thread(1));
  const ArmResult b = find_arm_closures(arm, pose, lanes(), one_thread(77));
  ASSERT_EQ(a.closures.size(), b.closures.size());
  for (std::size_t k = 0; k < a.closures.size(); ++k) {
    EXPECT_EQ(a.closures[k].id, b.closures[k].id);
    EXPECT_LT(distance(arm, a.closures[k].values, b.closures[k].values), 1e-9);
  }
}

TEST(ArmClosuresTest, LimitsAreToldAndClosuresBeyondThemKept) {
  const Arm arm = arm_of("kinova_j2s6s200", "j2s6s200_end_effector");
  Eigen::VectorXd own(6);
  own << 1, 4.5, 5, -2, 3.5, 0.5;  // within the limits, some beyond half a turn
  const ArmResult result =
      find_arm_closures(arm, forward_kinematics(arm, own), lanes(), one_thread());
  EXPECT_EQ(result.counts.real, 8U);
  bool is_found = false;
  std::uint64_t beyond = 0;
  for (const ArmClosure& closure : result.closures) {
    beyond += closure.beyond.empty() ? 0 : 1;
    EXPECT_LE(closure.values.cwiseAbs().maxCoeff(), std::numbers::pi);
    if (distance(arm, closure.values, own) > 1e-9) continue;
    is_found = true;
    EXPECT_TRUE(closure.beyond.empty());
    for (const Eigen::Index k : {1, 2, 4}) EXPECT_NEAR(closure.in_limits[k], own[k], 1e-9);
  }
  EXPECT_TRUE(is_found);
  EXPECT_EQ(beyond, result.counts.beyond_limits);
}

/// Typed in millimetres: paths over 500 m are not followed in double, and need not be.
TEST(ArmClosuresTest, APoseFartherAwayThanTheArmIsLongIsDecided) {
  const Arm arm = arm_of("puma560", "flange");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (const double x : {300.0, 1000.0, 3000.0}) {
    SCOPED_TRACE(x);
    pose.translation() << x, 100, 400;
    const ArmResult result = find_arm_closures(arm, pose, lanes(), one_thread());
    EXPECT_TRUE(result.complete);
    EXPECT_TRUE(result.closures.empty() && result.moves.empty());
    EXPECT_NE(result.message.find("all links in a row"), std::string::npos) << result.message;
  }
}

TEST(ArmClosuresTest, APoseOutOfReachHasNoRealClosure) {
  const Arm arm = arm_of("ur5", "tool0");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << 3, 1, 0.5;
  const ArmResult result = find_arm_closures(arm, pose, lanes(), one_thread());
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.counts.complex, 8U);
  EXPECT_TRUE(result.closures.empty());
}

}  // namespace
}  // namespace moivre::test
