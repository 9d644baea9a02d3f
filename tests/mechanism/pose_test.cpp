// SPDX-License-Identifier: MIT
// Do points move as their bodies do, and do guesses place bodies joint by joint?
#include "moivre/mechanism/pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "files.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::example;
using test::kDegree;

TEST(Pose, PointVelocityAndAccelerationAreDerivativesAlongTheMotion) {
  for (const char* name : {"four-bar", "bennett"}) {
    const Mechanism m = example(name);
    const VectorXd q = initial_guess(m);
    const VectorXd qdot = VectorXd::LinSpaced(q.size(), -1, 2);
    const VectorXd qddot = VectorXd::LinSpaced(q.size(), 3, -1);
    const PointOf point{2, 1};
    const auto at = [&](double s) {
      return point_position(m, point, q + s * qdot + s * s / 2 * qddot);
    };
    constexpr double kStep = 1e-4;
    const PointState state = point_state(m, point, q, qdot, qddot);
    EXPECT_LT((state.velocity - (at(kStep) - at(-kStep)) / (2 * kStep)).norm(), 1e-4) << name;
    EXPECT_LT((state.acceleration - (at(kStep) - 2 * at(0) + at(-kStep)) / (kStep * kStep)).norm(),
              1e-4)
        << name;
  }
}

TEST(Pose, JointCoordinateIsTheRelativeAngleOrTheDisplacement) {
  const Mechanism m = example("inverted-slider-crank");
  VectorXd q = VectorXd::Zero(9);
  q[2] = 0.3;
  q.segment<3>(3) << 1, 2, 0.5;
  q.segment<3>(6) << 4, 0, 90 * kDegree;
  EXPECT_NEAR(*joint_coordinate(m, m.joints[1], q), 0.2, 1e-15);
  EXPECT_NEAR(*joint_coordinate(m, m.joints[3], q), 2, 1e-14);  // along the lever, which points up
}

TEST(Pose, GuessPlacesBodiesFromTheGroundOutwards) {
  const Mechanism m = example("four-bar");
  const VectorXd q = initial_guess(m);
  EXPECT_NEAR(q[2], 40 * kDegree, 1e-15);  // driven
  EXPECT_NEAR(q[5], 20 * kDegree, 1e-15);  // guessed
  EXPECT_NEAR(q[3], 40 * std::cos(40 * kDegree), 1e-13);
  EXPECT_NEAR(q[6], 100, 1e-13);
}

TEST(Pose, PrismaticTurnIsKeptFromEitherEnd) {
  const std::string bodies =
      "[ground.points]\nO = [0, 0]\n[body.a.points]\nP = [1, 1]\n[[joint]]\ntype = \"prismatic\"\n"
      "along = [1, 0]\nturn = 0.5\n";
  for (const char* at : {"at = [\"ground.O\", \"a.P\"]\n", "at = [\"a.P\", \"ground.O\"]\n"}) {
    const Mechanism m = test::typed(bodies + at);
    EXPECT_LT(Phi(m).value(initial_guess(m), 0).norm(), 1e-15) << at;
  }
}

TEST(Pose, LimitsOfAnAngleMayCrossHalfATurn) {
  Mechanism m = example("four-bar");
  m.joints[2].limits = Limits{170 * kDegree, 190 * kDegree};
  VectorXd q = VectorXd::Zero(9);
  q[8] = -175 * kDegree;
  EXPECT_TRUE(is_within_limits(m, m.joints[2], q));
  q[8] = -165 * kDegree;
  EXPECT_FALSE(is_within_limits(m, m.joints[2], q));
}

TEST(Pose, DrivenSlideOfASpatialPrismaticJointPlacesItsBody) {
  const Mechanism m = test::typed(R"toml(
space = "spatial"
[ground.points]
O = [1, 0, 0]
[body.a.points]
P = [0, 0, 0]
[[joint]]
type = "prismatic"
at = ["ground.O", "a.P"]
axis = [0, 0, 2]
name = "lift"
[[driver]]
slide = "lift"
start = 5
)toml");
  const VectorXd q = initial_guess(m);
  EXPECT_LT((q.head(3) - Eigen::Vector3d(1, 0, 5)).norm(), 1e-15);
  EXPECT_LT(Phi(m).value(q, 0).norm(), 1e-15);
}

}  // namespace
}  // namespace moivre
