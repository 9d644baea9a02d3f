// SPDX-License-Identifier: MIT
// Does the eigenvalue problem of a general arm propose all of its sixteen closures, and is a
// proposal of something else found out?
#include "pair_formula.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "formula_ends.h"
#include "robots.h"

namespace moivre::test {
namespace {

constexpr std::size_t kClosures = 16;

std::optional<FoundClosures> found_at(const PairFormula& formula, const Arm& arm,
                                      const Eigen::Isometry3d& pose) {
  return closures_proposed(proposed_closures(formula, pose), arm, pose, kClosures);
}

bool has(const Arm& arm, const FoundClosures& found, const Eigen::VectorXd& own) {
  return std::any_of(found.real.begin(), found.real.end(),
                     [&](const Polished& real) { return distance(arm, real.values, own) < 1e-8; });
}

/// Where it does not answer the tip's way does: one in a thousand at the most.
TEST(PairFormulaTest, HasSixteenClosuresAndThePosesOwnAmongThem) {
  constexpr std::uint64_t kPoses = 300, kFewest = 2 * 4 * kPoses - 2;
  std::uint64_t answered = 0;
  for (const DenavitHartenberg& dh :
       {kManseurDoty, general_arm(1), general_arm(2), general_arm(3)}) {
    const Arm arm = arm_of(dh);
    for (const std::uint64_t seed : {1U, 2U}) {
      const auto formula = pair_formula(arm, seed);
      ASSERT_TRUE(formula);
      for (std::uint64_t k = 0; k < kPoses; ++k) {
        const Eigen::VectorXd own = random_values(arm, 31, k);
        const auto found = found_at(*formula, arm, forward_kinematics(arm, own));
        if (!found) continue;
        ++answered;
        EXPECT_EQ(found->real.size() + 2 * found->pairs.size(), kClosures);
        EXPECT_TRUE(has(arm, *found, own)) << "pose " << k;
      }
    }
  }
  EXPECT_GE(answered, kFewest);
}

TEST(PairFormulaTest, OfAPoseOutOfReachHasPairsOnly) {
  const Arm arm = arm_of(general_arm(1));
  const auto formula = pair_formula(arm, 1);
  ASSERT_TRUE(formula);
  Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
  far.translation() << 20, 3, 1;
  const auto found = found_at(*formula, arm, far);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->real.empty());
}

TEST(PairFormulaTest, ThatProposesSomethingElseIsFoundOut) {
  const Arm arm = arm_of(general_arm(1));
  const auto wrong = pair_formula(arm_of(general_arm(2)), 1);
  ASSERT_TRUE(wrong);
  EXPECT_FALSE(found_at(*wrong, arm, forward_kinematics(arm, random_values(arm, 32, 0))));
}

/// Between postures of one and of the other sign of the Jacobian's determinant, halved 60 times, is
/// one at which closures meet.
TEST(PairFormulaTest, WhoseClosuresMeetDoesNotAnswer) {
  const Arm arm = arm_of(kManseurDoty);
  const auto formula = pair_formula(arm, 1);
  ASSERT_TRUE(formula);
  const auto determinant = [&](const Eigen::VectorXd& values) {
    const Eigen::Matrix<double, 6, 6> screws =
        linearized(arm, forward_kinematics(arm, values), values).screws;
    return screws.determinant();
  };
  Eigen::VectorXd one = random_values(arm, 33, 0), other = one;
  for (std::uint64_t k = 1; determinant(one) * determinant(other) > 0; ++k) {
    other = random_values(arm, 33, k);
  }
  for (int k = 0; k < 60; ++k) {
    const Eigen::VectorXd middle = (one + other) / 2;
    (determinant(middle) * determinant(one) > 0 ? one : other) = middle;
  }
  EXPECT_FALSE(found_at(*formula, arm, forward_kinematics(arm, one)));
}

TEST(PairFormulaTest, IsOfTurnsWithoutAGroupOnly) {
  EXPECT_FALSE(pair_formula(arm_of(kPuma), 1));
  Robot robot = robot_of(general_arm(1));
  robot.joints[2].type = RobotJointType::prismatic;
  robot.joints[2].limits = Limits{-1, 1};
  EXPECT_FALSE(pair_formula(make_arm(robot, {}), 1));
}

}  // namespace
}  // namespace moivre::test
