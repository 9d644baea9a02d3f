// SPDX-License-Identifier: MIT
// Does every way in which a Newton-Raphson run can end have its status, its message and its numbers?
#include "moivre/kinematics/newton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "../mechanism/files.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::example;
using test::typed;

NewtonResult run_on(const std::string& equation, double guess, NewtonOptions options = {}) {
  const Phi phi(typed("[unknowns]\nlengths = [\"x\"]\n[equations]\ne = \"" + equation + "\"\n"));
  return newton(phi, VectorXd::Constant(1, guess), 0, options);
}

TEST(Newton, ConvergesQuadratically) {
  const NewtonResult run = run_on("x^2 - 2", 1.5);
  EXPECT_EQ(run.status, NewtonStatus::converged);
  EXPECT_FALSE(run.is_singular);
  EXPECT_LE(run.steps(), 4);
  EXPECT_NEAR(run.smallest_singular_value, 2 * std::sqrt(2.0), 1e-14);
}

TEST(Newton, DivergesWhereTheIteratesFly) {
  const NewtonResult run = run_on("atan(x)", 2);
  EXPECT_EQ(run.status, NewtonStatus::diverged);
  EXPECT_NE(run.message.find("diverged"), std::string::npos);
}

TEST(Newton, DivergesWherePhiIsNotDefined) {
  EXPECT_EQ(run_on("sqrt(x) + 1", 0.5).status, NewtonStatus::diverged);
}

TEST(Newton, StopsAtASingularJacobian) {
  const NewtonResult run = run_on("x^2 + 1", 0);
  EXPECT_EQ(run.status, NewtonStatus::singular);
  EXPECT_TRUE(run.is_singular);
  EXPECT_EQ(run.rank, 0);
}

TEST(Newton, ReportsADoubleRootAsSingular) {
  const NewtonResult run = run_on("(x - 1)^2", 1);
  EXPECT_EQ(run.status, NewtonStatus::converged);
  EXPECT_TRUE(run.is_singular);
}

TEST(Newton, SaysWhereEquationsContradictEachOther) {
  const Phi phi(
      typed("[unknowns]\nlengths = [\"x\"]\n[equations]\na = \"x - 1\"\nb = \"x - 2\"\n"));
  const NewtonResult run = newton(phi, VectorXd::Zero(1));
  EXPECT_EQ(run.status, NewtonStatus::no_solution);
  EXPECT_NEAR(run.q[0], 1.5, 1e-14);
}

TEST(Newton, GivesUpAtTheIterationLimit) {
  NewtonOptions options;
  options.maximum_iterations = 3;
  const NewtonResult run = run_on("x^2 + 1", 0.6, options);
  EXPECT_EQ(run.status, NewtonStatus::iteration_limit);
  EXPECT_EQ(run.steps(), 3);
}

TEST(Newton, FindsCyclesOfMoreThanTwoSteps) {
  // Hermite's quintic with p = 1, 1, 2 and p' = -1, -1, 1 at 0, 1, 2: Newton goes 0, 1, 2, 0.
  const NewtonResult run =
      run_on("1 + (-1)*x^1 + (33/4)*x^2 + (-57/4)*x^3 + (35/4)*x^4 + (-7/4)*x^5", 0);
  EXPECT_EQ(run.status, NewtonStatus::cycling);
  EXPECT_EQ(run.cycle_length, 3);
}

TEST(Newton, RefusesAWrongGuessWithEveryRule) {
  const Phi phi(example("four-bar"));
  NewtonOptions options;
  options.residual_tolerance = 0;
  try {
    newton(phi, VectorXd::Zero(2), 0, options);
    FAIL() << "the guess has the wrong size";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("2 entries, there are 9"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("residual_tolerance"), std::string::npos);
  }
}

TEST(Newton, IterationTableHoldsMethodRankAndStep) {
  const Mechanism m = example("redundant-system");
  const NewtonResult run = newton(Phi(m), initial_guess(m));
  for (const NewtonIteration& row : run.iterations) {
    EXPECT_EQ(row.method, LinearMethod::qr);
    EXPECT_EQ(row.rank, 5);
  }
  EXPECT_GT(run.iterations.front().step, 0);
  EXPECT_EQ(run.iterations.back().step, 0);
}

TEST(Newton, AcceptsARowWhoseTermsAreAllRoundingNoise) {
  const Mechanism m =
      example("jansen-leg");  // at crank angle 0 several coordinates are exactly zero
  const NewtonResult run = newton(Phi(m), initial_guess(m));
  EXPECT_EQ(run.status, NewtonStatus::converged);
  EXPECT_LE(run.scaled_residual, 1e-13);
}

TEST(Newton, AnAngleOfManyTurnsMakesNoNoiseOfLengths) {
  const Mechanism m = typed(
      "[unknowns]\nangles = [\"a\"]\nlengths = [\"d\"]\n[equations]\n"
      "across = \"1e-9*cos(a) - d\"\nup = \"1e-9*sin(a) - 5e-10\"\n");
  VectorXd guess(2);
  guess << 6e6, 9e-10;
  const NewtonResult run = newton(Phi(m), guess);
  ASSERT_EQ(run.status, NewtonStatus::converged);
  constexpr double kRoundingOfTheAngle = 1e-8;  // 6e6 rad is known to 1e-9
  EXPECT_NEAR(std::abs(run.q[1]) / 1e-9, std::sqrt(0.75), kRoundingOfTheAngle);
}

TEST(Newton, UnassemblableTriangleDoesNotConverge) {
  const Mechanism m = example("unassemblable-triangle");
  EXPECT_NE(newton(Phi(m), initial_guess(m)).status, NewtonStatus::converged);
}

}  // namespace
}  // namespace moivre
