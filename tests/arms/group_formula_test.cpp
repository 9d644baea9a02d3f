// SPDX-License-Identifier: MIT
// Does the formula have all closures of an arm with a group, wherever it is in the arm? And is it
// found out where it has not?
#include <gtest/gtest.h>

#include "../../src/arms/formula_ends.h"
#include "../../src/arms/regular_pose.h"
#include "robots.h"

namespace moivre::test {
namespace {

struct Case {
  const char* name;
  DenavitHartenberg dh;
};

/// No two links alike but for the group's: neighbours outside it are skew, parallel or meet as
/// said.
std::vector<Case> cases() {
  return {{"wrist at the tip, two parallel", kKr6},
          {"wrist at the tip, two that meet", kPuma},
          {"wrist at the tip, all others skew",
           {{0.1, 0.4, 0.2, 0, 0, 0.1}, {0.3, 0.1, 0.2, 0.4, 0, 0.1}, {50, 70, 40, 80, 60, 0}}},
          {"wrist at the base",
           {{0, 0, 0.1, 0.5, 0.2, 0}, {0, 0, 0.4, 0.1, 0.3, 0.2}, {80, 60, 70, 30, 50, 0}}},
          {"wrist in the middle",
           {{0.3, 0, 0, 0.2, 0.1, 0}, {0.1, 0.2, 0, 0.3, 0.4, 0.1}, {70, 80, -60, 50, 40, 0}}},
          {"parallel at the base",
           {{0.4, 0.3, 0.1, 0.2, 0.3, 0}, {0.2, 0.1, 0.3, 0.1, 0.2, 0.3}, {0, 0, 70, 50, 80, 0}}},
          {"parallel in the middle, two that meet",
           {{0, -0.425, -0.39225, 0, 0, 0},
            {0.0892, 0, 0, 0.1092, 0.0947, 0.0823},
            {90, 0, 0, 90, -90, 0}}},
          {"parallel at the tip",
           {{0.3, 0.1, 0.2, 0.3, 0.4, 0.1}, {0.1, 0.2, 0.3, 0.1, 0.2, 0}, {60, 50, 70, 0, 0, 0}}}};
}

struct Known {
  Arm arm;
  RegularPose regular;
  GroupFormula formula;
};

Known known(const Case& of) {
  Known result{arm_of(of.dh), {}, {}};
  result.regular = find_regular_pose(result.arm, lanes(), one_thread(), std::atomic<bool>{false});
  const auto formula = group_formula(result.arm, result.regular.cut);
  EXPECT_TRUE(formula);
  result.formula = formula.value_or(GroupFormula{});
  return result;
}

std::optional<FoundClosures> found_at(const Known& of, const Eigen::Isometry3d& pose) {
  return closures_proposed(proposed_closures(of.formula, pose), of.arm, pose,
                           of.regular.roots.size());
}

TEST(GroupFormulaTest, HasAsManyClosuresAsARegularPoseAndThePosesOwnAmongThem) {
  constexpr std::uint64_t kPoses = 200;
  for (const Case& each : cases()) {
    SCOPED_TRACE(each.name);
    const Known of = known(each);
    ASSERT_EQ(of.regular.roots.size(), 8U);
    for (std::uint64_t k = 0; k < kPoses; ++k) {
      const Eigen::VectorXd own = random_values(of.arm, 21, k);
      const auto found = found_at(of, forward_kinematics(of.arm, own));
      ASSERT_TRUE(found) << "pose " << k;
      const bool has_own = std::any_of(
          found->real.begin(), found->real.end(),
          [&](const Polished& real) { return distance(of.arm, real.values, own) < 1e-8; });
      EXPECT_TRUE(has_own) << "pose " << k;
    }
  }
}

TEST(GroupFormulaTest, OfAPoseOutOfReachHasPairsOnly) {
  const Known of = known(cases().front());
  Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
  far.translation() << 3, 1, 0.5;
  const auto found = found_at(of, far);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->real.empty());
  EXPECT_EQ(ends_of(*found).size(), 8U);
}

TEST(GroupFormulaTest, ThatProposesSomethingElseIsFoundOut) {
  for (const Case& each : cases()) {
    SCOPED_TRACE(each.name);
    Known of = known(each);
    const Eigen::Isometry3d pose = forward_kinematics(of.arm, random_values(of.arm, 22, 0));
    ASSERT_TRUE(found_at(of, pose));
    Known wrong = of;
    for (JointLink& link : wrong.formula.before) link.t *= 1.5;
    EXPECT_FALSE(found_at(wrong, pose)) << "links of another length";
    EXPECT_FALSE(closures_proposed(proposed_closures(of.formula, pose), of.arm, pose, 16))
        << "too few";
  }
}

TEST(GroupFormulaTest, WhoseClosuresMeetDoesNotAnswer) {
  const Known of = known(cases().front());
  Eigen::VectorXd straight(6);
  straight << 0.3, 0.4, 0.5, 0.2, 0, 0.1;
  EXPECT_FALSE(found_at(of, forward_kinematics(of.arm, straight))) << "its wrist moves";
  Eigen::VectorXd stretched(6);
  stretched << 0.3, 0.4, -std::atan2(0.365, -0.035), 0.2, 0.7, 0.1;
  EXPECT_FALSE(found_at(of, forward_kinematics(of.arm, stretched))) << "elbow up is elbow down";
}

TEST(GroupFormulaTest, OfANumberOffByAMicroradianStillLeadsToTheClosuresOfTheArmAsTyped) {
  Known of = known(cases().front());
  for (JointLink& link : of.formula.before) {
    link.R = link.R * Eigen::AngleAxisd(1e-6, Eigen::Vector3d::UnitX()).toRotationMatrix();
  }
  const Eigen::VectorXd own = random_values(of.arm, 23, 0);
  const auto found = found_at(of, forward_kinematics(of.arm, own));
  ASSERT_TRUE(found);
  double least = 1;
  for (const Polished& real : found->real) {
    least = std::min(least, distance(of.arm, real.values, own));
    EXPECT_LT(real.residual, 1e-14);
  }
  EXPECT_LT(least, 1e-10);
}

TEST(GroupFormulaTest, IsThereForAGroupOfTurnsAlone) {
  const Arm general = arm_of(general_arm(1));
  const RegularPose regular =
      find_regular_pose(general, lanes(), one_thread(), std::atomic<bool>{false});
  EXPECT_FALSE(group_formula(general, regular.cut));
}

}  // namespace
}  // namespace moivre::test
