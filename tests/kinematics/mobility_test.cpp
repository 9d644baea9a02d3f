// SPDX-License-Identifier: MIT
// Are freedoms, idle freedoms, redundancy and singular poses found and named?
#include "moivre/kinematics/mobility.h"

#include <gtest/gtest.h>

#include "../mechanism/files.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::example;
using test::typed;

Mobility mobility_of(const std::string& name) {
  const Mechanism m = example(name);
  const NewtonResult run = newton(Phi(m), initial_guess(m));
  EXPECT_EQ(run.status, NewtonStatus::converged) << name;
  return mobility(Phi(m), run.q);
}

TEST(Mobility, BennettMovesAgainstGruebler) {
  const Mobility m = mobility_of("bennett");
  EXPECT_EQ(m.gruebler, -2);
  EXPECT_EQ(m.rank, 17);
  EXPECT_EQ(m.degrees_of_freedom, 1);
  EXPECT_EQ(m.redundant.size(), 3U);
  EXPECT_EQ(m.driven_freedoms, 0);
}

TEST(Mobility, CouplerBetweenTwoBallsSpinsIdly) {
  Mechanism m = typed(test::kSpinningCoupler);
  m.guess = {{"coupler.ry", 0.3},
             {"coupler.rz", 0.6},
             {"rocker.rx", -0.5},
             {"rocker.ry", 0.5},
             {"rocker.rz", 1.5}};
  const Phi phi(m);
  const NewtonResult run = newton(phi, initial_guess(m));
  ASSERT_EQ(run.status, NewtonStatus::converged) << run.message;
  const Mobility mob = mobility(phi, run.q);
  EXPECT_EQ(mob.degrees_of_freedom, 2);
  EXPECT_EQ(mob.driven_freedoms, 1);
  ASSERT_EQ(mob.idle.size(), 1U);
  EXPECT_EQ(mob.idle[0].name, "coupler");
  EXPECT_LT((phi.jacobian(run.q, 0) * mob.idle[0].direction).norm(), 1e-13);
}

TEST(Mobility, BodyIsIdleUntilADriverHoldsIt) {
  const std::string crank =
      "[ground.points]\nO = [0, 0]\n[body.crank.points]\nO = [0, 0]\n[[joint]]\ntype = "
      "\"revolute\"\n"
      "at = [\"ground.O\", \"crank.O\"]\n";
  const Mechanism loose = typed(crank);
  const Mobility free = mobility(Phi(loose), initial_guess(loose));
  ASSERT_EQ(free.idle.size(), 1U);
  EXPECT_EQ(free.idle[0].name, "crank");
  const Mechanism driven = typed(crank + "[[driver]]\nangle = \"crank\"\nstart = 1\n");
  const Mobility held = mobility(Phi(driven), initial_guess(driven));
  EXPECT_TRUE(held.idle.empty());
  EXPECT_EQ(held.drivers, 1);
  EXPECT_EQ(held.degrees_of_freedom, 1);
  EXPECT_EQ(held.driven_freedoms, 0);
  EXPECT_EQ(held.independent, std::vector<Eigen::Index>{2});
}

TEST(Mobility, FitDoesNotMakeATriangleMove) {
  const Mechanism m = typed(
      "[ground.points]\nO = [0, 0]\nP = [4, 0]\n[body.left.points]\nO = [0, 0]\nA = [3, 0]\n"
      "[body.right.points]\nP = [0, 0]\nA = [2, 0]\n"
      "[[joint]]\ntype = \"revolute\"\nat = [\"ground.O\", \"left.O\"]\n"
      "[[joint]]\ntype = \"revolute\"\nat = [\"ground.P\", \"right.P\"]\n"
      "[[joint]]\ntype = \"revolute\"\nat = [\"left.A\", \"right.A\"]\n"
      "[guess]\nleft.phi = 0.5\nright.phi = 2.3\n");
  const Phi phi(m);
  const NewtonResult run = newton(phi, initial_guess(m));
  constexpr double kFit = 0.04;  // a hundredth of the longest side
  const Mobility within = mobility(phi, run.q, 0, kFit);
  EXPECT_TRUE(within.is_assembled);
  EXPECT_EQ(within.degrees_of_freedom, 0);
  EXPECT_TRUE(within.redundant.empty());
}

TEST(Mobility, ParallelogramAtItsChangePointIsSingularNotFreer) {
  const Mobility m = mobility_of("parallelogram");
  EXPECT_EQ(m.degrees_of_freedom, 2);
  EXPECT_TRUE(m.is_singular);
  EXPECT_EQ(m.rank_nearby, 8);
}

TEST(Mobility, WhatIsIdleAtASingularPoseIsSoNextToItAndAlongItsMotion) {
  const Phi phi(test::collinear_rods("[0, 0] [2, 0] [5, 0]", 2));
  const Mobility m = mobility(phi, Eigen::Vector3d(2, 0, 0));
  EXPECT_TRUE(m.is_singular);
  EXPECT_EQ(m.rank_nearby, 2);
  ASSERT_EQ(m.idle.size(), 1U);
  EXPECT_LT((m.idle[0].direction - Eigen::Vector3d(0, 1, 0)).norm(), 1e-7);
}

// Two lines cross at the origin: each unknown moves alone to first order, and neither really.
TEST(Mobility, WhatMovesAloneToFirstOrderOnlyIsNotIdle) {
  const Phi phi(
      typed("[unknowns]\nlengths = [\"x\", \"y\"]\n[equations]\na = \"x*x + x*y - 2*y*y\"\n"));
  const Mobility m = mobility(phi, VectorXd::Zero(2));
  EXPECT_TRUE(m.is_singular);
  EXPECT_EQ(m.degrees_of_freedom, 2);
  EXPECT_TRUE(m.idle.empty());
}

TEST(Mobility, PoseNearAChangePointIsWarnedOf) {
  Mechanism m = example("parallelogram");
  const Phi phi(m);
  const double crank = 1e-6;
  VectorXd q(9);
  q << 0, 0, crank, 2 * std::cos(crank), 2 * std::sin(crank), 0, 4, 0, crank;
  const Mobility mob = mobility(phi, q);
  EXPECT_EQ(mob.rank, 8);
  EXPECT_TRUE(mob.is_near_singular);
  ASSERT_FALSE(mob.warnings.empty());
  EXPECT_TRUE(
      mob.warnings[0].starts_with("near a singular pose: the smallest counted singular value is "))
      << mob.warnings[0];
}

TEST(Mobility, PoseThatIsNotAssembledIsSaidToBe) {
  const Mechanism m = example("four-bar");
  const Mobility mob = mobility(Phi(m), VectorXd::LinSpaced(9, 1, 2));
  ASSERT_FALSE(mob.warnings.empty());
  EXPECT_EQ(mob.warnings[0],
            "the pose is not assembled: these figures hold where Phi = 0, assemble it first");
}

TEST(Mobility, RigidStructuresHaveNoFreedom) {
  for (const char* name : {"3-rpr", "assur-7-quaternary", "assur-7-serial"}) {
    const Mobility m = mobility_of(name);
    EXPECT_EQ(m.degrees_of_freedom, 0) << name;
    EXPECT_EQ(m.null_space.cols(), 0) << name;
    EXPECT_FALSE(m.is_singular) << name;
  }
}

TEST(Mobility, RowThatSaysNothingIsRedundantWithoutACombination) {
  const Phi phi(typed(
      "[unknowns]\nlengths = [\"x\", \"y\"]\n[equations]\na = \"x + y\"\nb = \"x - x + 0*y\"\n"));
  const Mobility m = mobility(phi, VectorXd::Zero(2));
  ASSERT_EQ(m.redundant.size(), 1U);
  EXPECT_EQ(to_text(m.redundant[0]), "b = 0");
}

}  // namespace
}  // namespace moivre
