// SPDX-License-Identifier: MIT
// Does one come from a complex place to the set of real postures whose continuation it is on, and
// from other complex places nowhere?
#include "../../src/arms/complex_set.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include "../../src/arms/formula_ends.h"
#include "../../src/arms/regular_pose.h"
#include "robots.h"

namespace moivre::test {
namespace {

constexpr double kTold = 1e-10;

/// A UR5: at home four axes are parallel, and their turns go along a curve that is no plane's.
const DenavitHartenberg kFourParallel{
    {0, -0.425, -0.39225, 0, 0, 0}, {0.0892, 0, 0, 0.1092, 0.0947, 0.0823}, {90, 0, 0, 90, -90, 0}};

/// The complex posture that holds the pose of `real` with joint 2 this far into complex numbers.
JointVector<Complex> continued(const Arm& arm, const Eigen::VectorXd& real, double imaginary) {
  constexpr Eigen::Index kHeld = 1;
  const TipMotion<Complex> at = tip_motion<Complex>(arm, real.cast<Complex>());
  JointVector<Complex> values = real.cast<Complex>();
  constexpr int kSteps = 20;
  for (int k = 0; k < kSteps; ++k) {
    values[kHeld] += Complex(0, imaginary / kSteps);
    for (int n = 0; n < 8; ++n) {
      const TipMotion<Complex> motion = tip_motion<Complex>(arm, values);
      Eigen::MatrixXcd screws = motion.screws;
      screws.col(kHeld).setZero();
      const Eigen::VectorXcd error = small_difference<Complex>(arm, at.tip, motion.tip);
      values += screws.completeOrthogonalDecomposition().solve(error);
    }
  }
  return values;
}

TEST(ComplexSetTest, LeadsBackToTheCurve) {
  const Arm arm = arm_of(kFourParallel);
  const Eigen::VectorXd on_curve{{0, 0.7, -1.1, 0.2, 0, 0.3}};
  const Eigen::Isometry3d pose = forward_kinematics(arm, on_curve);
  for (const double imaginary : {-0.4, 0.05, 0.3}) {
    const JointVector<Complex> from = continued(arm, on_curve, imaginary);
    ASSERT_LT((from.imag().cwiseAbs() - Eigen::VectorXd::Constant(6, 2)).maxCoeff(), 0);
    const auto real = real_place_of(arm, pose, from, kTold);
    ASSERT_TRUE(real) << imaginary;
    EXPECT_TRUE(forward_kinematics(arm, *real).isApprox(pose, 1e-9));
    EXPECT_NEAR((*real)[4], 0, 1e-9) << "the wrist stays straight";
  }
}

TEST(ComplexSetTest, AClosureThatIsNotRealLeadsNowhere) {
  const Arm arm = arm_of(kFourParallel);
  const RegularPose regular =
      find_regular_pose(arm, lanes(), one_thread(), std::atomic<bool>{false});
  const auto formula = group_formula(arm, regular.cut);
  ASSERT_TRUE(formula);
  std::size_t pairs = 0;
  for (std::uint64_t k = 0; k < 100; ++k) {
    const Eigen::Isometry3d pose = forward_kinematics(arm, random_values(arm, 17, k));
    const auto found =
        closures_proposed(proposed_closures(*formula, pose), arm, pose, regular.roots.size());
    if (!found) continue;
    for (const ConjugatePair& pair : found->pairs) {
      EXPECT_FALSE(real_place_of(arm, pose, pair.values, kTold));
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 20U);
}

}  // namespace
}  // namespace moivre::test
