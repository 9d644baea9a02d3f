// SPDX-License-Identifier: MIT
// Is a pose told that stands from one that moves, where the null space of Phi_q does not tell?
#include "moivre/kinematics/local_dimension.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../mechanism/files.h"
#include "moivre/kinematics/newton.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::example;
using test::kDegree;
using test::triangle_text;
using test::typed;

VectorXd pose_of(const Mechanism& mechanism) {
  const NewtonResult run = newton(Phi(mechanism), initial_guess(mechanism));
  EXPECT_EQ(run.status, NewtonStatus::converged) << run.message;
  return run.q;
}

TEST(LocalDimension, OfAnAssembledDrivenMechanismIsZero) {
  const Mechanism m = example("four-bar");
  EXPECT_EQ(local_dimension(Phi(m), pose_of(m)).dimension, 0);
}

TEST(LocalDimension, CountsTheCoordinatesThatIndependentConstraintsLeave) {
  Mechanism m = example("five-bar");
  const VectorXd q = pose_of(m);
  m.drivers.pop_back();
  EXPECT_EQ(local_dimension(Phi(m), q).dimension, 1);
  m.drivers.pop_back();
  EXPECT_EQ(local_dimension(Phi(m), q).dimension, 2);
}

TEST(LocalDimension, AFoldedTriangleStandsThoughItsNullSpaceDoesNot) {
  const Phi phi(typed(triangle_text("3")));
  VectorXd q(6);
  q << 0, 0, 0, 3, 0, 0;
  ASSERT_LT(phi.value(q, 0).norm(), 1e-15);
  ASSERT_EQ(numerical_rank(phi.jacobian(q, 0)), 5);
  const LocalDimension found = local_dimension(phi, q);
  EXPECT_EQ(found.dimension, 0);
  EXPECT_EQ(found.shown, "second random slices beside this pose meet no closure");
}

VectorXd parallel_cranks(double crank_rad) {
  VectorXd q = VectorXd::Zero(12);
  q.segment<3>(0) << 0, 0, crank_rad;
  q.segment<3>(3) << 3, 0, crank_rad;
  q.segment<3>(6) << 6, 0, crank_rad;
  q.segment<3>(9) << 2 * std::cos(crank_rad), 2 * std::sin(crank_rad), 0;
  return q;
}

TEST(LocalDimension, AThirdParallelCrankMovesThoughTheCountOfEquationsSaysNo) {
  const Phi phi = Phi(example("double-parallel-crank")).without_drivers();
  ASSERT_EQ(phi.size(), phi.dimension());
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const LocalDimension found = local_dimension(phi, parallel_cranks(60 * kDegree), 0, seed);
    EXPECT_EQ(found.dimension, 1) << seed;
    EXPECT_EQ(found.shown, "second random slices beside a pose meet the closures again");
  }
}

TEST(LocalDimension, WhereTwoMotionsCrossTheNullSpaceHasADirectionTooMany) {
  const Phi phi = Phi(example("double-parallel-crank")).without_drivers();
  ASSERT_EQ(numerical_rank(phi.jacobian(parallel_cranks(0), 0)), 10);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_EQ(local_dimension(phi, parallel_cranks(0), 0, seed).dimension, 1) << seed;
  }
}

TEST(LocalDimension, AChangePointStandsWhileItsCrankIsHeldAndMovesWhenItIsFree) {
  const Phi held(example("parallelogram"));
  VectorXd q = VectorXd::Zero(9);
  q.segment<3>(3) << 2, 0, 0;
  q.segment<3>(6) << 4, 0, 0;
  ASSERT_LT(held.value(q, 0).norm(), 1e-15);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_EQ(local_dimension(held, q, 0, seed).dimension, 0) << seed;
    EXPECT_EQ(local_dimension(held.without_drivers(), q, 0, seed).dimension, 1) << seed;
  }
}

TEST(LocalDimension, BennettsLinkageMovesInSpaceThoughItsCountIsMinusTwo) {
  const Mechanism m = example("bennett");
  const VectorXd q = pose_of(m);
  const Phi joints = Phi(m).without_drivers();
  ASSERT_LT(joints.dimension(), joints.size());
  EXPECT_EQ(local_dimension(joints, q).dimension, 1);
  EXPECT_EQ(local_dimension(Phi(m), q).dimension, 0);
}

}  // namespace
}  // namespace moivre
