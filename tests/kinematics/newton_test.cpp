// SPDX-License-Identifier: MIT
// Does every way in which a Newton-Raphson run can end have its status, its message and its
// numbers?
#include "moivre/kinematics/newton.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

#include "../mechanism/files.h"
#include "moivre/factorization/svd.h"

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

TEST(Newton, HasTheSingularValuesOfAnSvdWhereThereAreManyCoordinates) {
  for (const char* name : {"jansen-leg", "assur-7-serial", "stephenson-3", "rssr"}) {
    const Mechanism mechanism = example(name);
    const Phi phi(mechanism);
    NewtonOptions options;
    options.with_condition = true;
    const NewtonResult run = newton(phi, initial_guess(mechanism), 0, options);
    const Eigen::MatrixXd J = phi.jacobian(run.q, 0);
    const VectorXd raw = singular_values(J);
    const VectorXd scaled = singular_values(equilibrated(J));
    const Eigen::Index last = raw.size() - 1;
    EXPECT_NEAR(run.smallest_singular_value / raw[last], 1, 1e-9) << name;
    EXPECT_NEAR(run.condition * scaled[last] / scaled[0], 1, 1e-9) << name;
  }
}

TEST(Newton, DivergesWhereTheIteratesFly) {
  const NewtonResult run = run_on("atan(x)", 2);
  EXPECT_EQ(run.status, NewtonStatus::diverged);
  EXPECT_EQ(run.message,
            "diverged after 5 steps: the iterates leave every bound; try another guess");
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
    EXPECT_EQ(std::string(error.what()),
              "the guess has 2 entries, there are 9 coordinates. residual_tolerance must be finite "
              "and positive.");
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

// A lift under a plate on a ball, its corners held by three rods. From here an earlier version came
// to rest off the constraints, its rotation vectors billions long, and called that converged.
TEST(Newton, RotationVectorsStayShortOnTheWayFromAFarGuess) {
  const Mechanism m = typed(R"toml(
space = "spatial"
[units]
angle = "deg"
[ground.points]
A = [0, 0, 0]
B = [4, 0, 0]
C = [0, 4, 0]
[body.ram.points]
R = [0, 0, 0]
[body.cap.points]
K = [0, 0, 0]
T = [0, 0, 1]
[body.plate.points]
P = [0, 0, 0]
Q = [3, 0, 0]
S = [0, 3, 0]
[[joint]]
type = "prismatic"
name = "lift"
at = ["ground.A", "ram.R"]
axis = [0, 0, 1]
turn = 15
[[joint]]
type = "weld"
at = ["ram.R", "cap.K"]
axis = [0, 0, 1]
turn = 30
[[joint]]
type = "spherical"
at = ["cap.T", "plate.P"]
[[joint]]
type = "rod"
at = ["ground.B", "plate.Q"]
length = 4
[[joint]]
type = "rod"
at = ["ground.C", "plate.S"]
length = 4.2
[[joint]]
type = "rod"
at = ["ground.B", "plate.S"]
length = 6
[[driver]]
slide = "lift"
start = 2
[guess]
"ram.z" = 2
"plate.z" = 3
"plate.rz" = 10
)toml");
  const Phi phi(m);
  const NewtonResult run = newton(phi, initial_guess(m));
  EXPECT_EQ(run.status, NewtonStatus::converged) << run.message;
  EXPECT_LE(phi.value(run.q, 0).lpNorm<Eigen::Infinity>(), 1e-12);
  constexpr double kLongest = 1.25 * 3.15;
  for (const NewtonIteration& row : run.iterations) {
    EXPECT_LE(row.q.tail(3).norm(), kLongest);
  }
}

TEST(Newton, ALongRodBesideDoesNotHideAContradiction) {
  // The bar of 2 does not reach from P to Q; a rod of 1e7 stands elsewhere.
  const Mechanism m = typed(R"toml(
[ground.points]
P = [0, 0]
Q = [2.5, 0]
[body.bar.points]
P = [0, 0]
Q = [2, 0]
[body.far.points]
F = [0, 0]
G = [3, 0]
[[joint]]
type = "revolute"
at = ["ground.P", "bar.P"]
[[joint]]
type = "revolute"
at = ["ground.Q", "bar.Q"]
[[joint]]
type = "revolute"
name = "foot"
at = ["ground.P", "far.F"]
[[joint]]
type = "rod"
at = ["ground.Q", "far.G"]
length = 1e7
[guess]
"bar.phi" = 1
"far.phi" = 2
)toml");
  EXPECT_NE(newton(Phi(m), initial_guess(m)).status, NewtonStatus::converged);
}

TEST(Newton, UnassemblableTriangleDoesNotConverge) {
  const Mechanism m = example("unassemblable-triangle");
  EXPECT_NE(newton(Phi(m), initial_guess(m)).status, NewtonStatus::converged);
}

}  // namespace
}  // namespace moivre
