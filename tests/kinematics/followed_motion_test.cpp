// SPDX-License-Identifier: MIT
// Is a direction told only where a motion leaves the pose along it?
#include "moivre/kinematics/followed_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../mechanism/files.h"
#include "moivre/kinematics/local_dimension.h"
#include "moivre/kinematics/own_units.h"

namespace moivre {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::collinear_rods;
using test::example;
using test::typed;

constexpr std::uint64_t kSeeds = 5;

Phi curve(const std::string& equation) {
  return Phi(
      typed("[unknowns]\nlengths = [\"x\", \"y\"]\n[equations]\na = \"" + equation + "\"\n"));
}

/// Whether one of the directions is along `wanted`, either way.
bool is_told(const std::vector<VectorXd>& directions, const VectorXd& wanted) {
  return std::any_of(directions.begin(), directions.end(), [&](const VectorXd& told) {
    return 1 - std::abs(told.normalized().dot(wanted.normalized())) <= kFollowed * kFollowed;
  });
}

TEST(FollowedMotion, OfRodsInLineIsTheCircleAndNotTheTurnThatTheRankAllows) {
  for (const char* at : {"[0, 0] [2, 0] [5, 0]", "[-1, 0] [0, 0] [1, 0]"}) {
    for (const double length : {1., 2., 3.}) {
      const Phi phi(collinear_rods(at, length));
      const Vector3d q(length, 0, 0);
      ASSERT_EQ(rank_of(phi, phi.jacobian(q, 0)), 1);
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const auto told = followed_directions(phi, q, 0, seed);
        ASSERT_EQ(told.size(), 1U) << at << ' ' << length << ' ' << seed;
        EXPECT_LT((told[0].normalized() - Vector3d(0, 1, 0)).norm(), kFollowed);
      }
    }
  }
}

TEST(FollowedMotion, AtAChangePointIsOfTheParallelogramAndOfTheAntiparallelogram) {
  const Phi phi = Phi(example("parallelogram")).without_drivers();
  VectorXd q = VectorXd::Zero(9);
  q[3] = 2;
  q[6] = 4;
  VectorXd parallel = VectorXd::Zero(9);
  parallel[2] = parallel[8] = 1;
  parallel[4] = 2;
  // Links of 2 and 4 in line: the rocker turns (4 + 2) / (4 - 2) times as fast, the other way.
  VectorXd crossed = VectorXd::Zero(9);
  crossed[2] = 1;
  crossed[4] = 2;
  crossed[5] = -2;
  crossed[8] = -3;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto told = followed_directions(phi, q, 0, seed);
    EXPECT_EQ(told.size(), 2U) << seed;
    EXPECT_TRUE(is_told(told, parallel)) << seed;
    EXPECT_TRUE(is_told(told, crossed)) << seed;
  }
}

TEST(FollowedMotion, OfACurveThatCrossesItselfIsAlongBothBranches) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto told = followed_directions(curve("y*y - x*x - x*x*x"), Vector2d(0, 0), 0, seed);
    EXPECT_EQ(told.size(), 2U) << seed;
    EXPECT_TRUE(is_told(told, Vector2d(1, 1))) << seed;
    EXPECT_TRUE(is_told(told, Vector2d(1, -1))) << seed;
  }
}

TEST(FollowedMotion, OfCurvesThatTouchIsTheirTangent) {
  const auto told = followed_directions(curve("y*y - x*x*x*x"), Vector2d(0, 0));
  EXPECT_EQ(told.size(), 1U);
  EXPECT_TRUE(is_told(told, Vector2d(1, 0)));
}

TEST(FollowedMotion, ThatTurnsBackInACuspHasNoDirection) {
  EXPECT_TRUE(followed_directions(curve("y*y - x*x*x"), Vector2d(0, 0)).empty());
}

TEST(FollowedMotion, OfARegularPoseIsTheNullVector) {
  const auto told = followed_directions(curve("x*x + y*y - 25"), Vector2d(3, 4));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(is_told(told, Vector2d(4, -3)));
}

TEST(FollowedMotion, OfWhatAloneMayMoveLeavesTheOthersAtRest) {
  const Phi phi(collinear_rods("[0, 0] [2, 0] [5, 0]", 2));
  const auto told = followed_directions(phi, Vector3d(2, 0, 0), 0, 1, {1, 2});
  EXPECT_TRUE(told.empty());  // without x it cannot stay on the circle
}

TEST(GenericPose, IsNextToOneWhereTheRankIsLower) {
  const Phi phi(collinear_rods("[0, 0] [2, 0] [5, 0]", 2));
  const VectorXd generic = generic_pose(phi, Vector3d(2, 0, 0));
  EXPECT_EQ(rank_of(phi, phi.jacobian(generic, 0)), 2);
  EXPECT_LT(residual_by_size(phi, generic, 0), kAssembled);
  EXPECT_LT((generic - Vector3d(2, 0, 0)).norm(), 1);
}

TEST(GenericPose, IsThePoseItselfWhereNoneHasAHigherRank) {
  const Phi phi(collinear_rods("[0, 0] [2, 0] [5, 0]", 2));
  EXPECT_EQ(generic_pose(phi, Vector3d(0, 2, 0)), Vector3d(0, 2, 0));
  VectorXd folded(6);
  folded << 0, 0, 0, 3, 0, 0;
  EXPECT_EQ(generic_pose(Phi(typed(test::triangle_text("3"))), folded), folded);
}

}  // namespace
}  // namespace moivre
