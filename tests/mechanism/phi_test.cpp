// SPDX-License-Identifier: MIT
// Are Phi's derivatives those of Phi, its scale that of its terms, its names those of the file?
#include "moivre/mechanism/phi.h"

#include <gtest/gtest.h>

#include <cmath>

#include "files.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::example;
using test::kDegree;
using test::typed;

const std::string kEverySpatialJoint = R"toml(
space = "spatial"
[ground.points]
O = [0, 0, 0]
Q = [3, 0, 1]
[body.a.points]
O = [0, 0, 0]
A = [1, 0.5, 0.2]
[body.b.points]
A = [0, 0, 0]
B = [0.3, 1, 0]
[body.c.points]
B = [0, 0.2, 0]
C = [1, 0, 0]
[body.d.points]
C = [0, 0, 0]
D = [0, 1, 1]
[body.e.points]
D = [0, 0, 0]
[body.f.points]
F = [1, 1, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "a.O"]
axis = [[0, 0.6, 0.8], [1, 0, 0]]
name = "pin"
[[joint]]
type = "cylindrical"
at = ["a.A", "b.A"]
axis = [0, 0, 1]
name = "sleeve"
[[joint]]
type = "prismatic"
at = ["b.B", "c.B"]
axis = [1, 1, 0]
turn = 0.4
name = "slider"
[[joint]]
type = "universal"
at = ["c.C", "d.C"]
axis = [[1, 0, 0], [0, 1, 0]]
[[joint]]
type = "weld"
at = ["d.D", "e.D"]
turn = 0.3
[[joint]]
type = "rod"
at = ["ground.Q", "e.D"]
length = 2
[[joint]]
type = "spherical"
at = ["e.D", "f.F"]
[[joint]]
type = "screw"
at = ["f.F", "a.A"]
axis = [1, 0, 2]
pitch = 0.7
name = "thread"
[[joint]]
type = "planar"
at = ["a.A", "c.C"]
axis = [[1, 2, 0], [0, 1, 0]]
[[joint]]
type = "point-on-line"
at = ["b.B", "e.D"]
axis = [0, 1, 1]
[[joint]]
type = "point-on-plane"
at = ["ground.Q", "c.B"]
axis = [1, 1, 1]
[[joint]]
type = "actuator"
at = ["ground.Q", "f.F"]
name = "leg"
[[driver]]
slide = "leg"
start = 1
velocity = 0.4
[[driver]]
angle = "thread"
velocity = 2
[[driver]]
angle = "pin"
value = "0.3 + sin(t)"
[[driver]]
slide = "slider"
start = 1
velocity = 0.5
[[driver]]
z = "f.F"
table = [[0, 0], [1, 2], [2, 1]]
)toml";

const std::string kTransmissions = R"toml(
[ground.points]
O = [0.2, 0.1]
Q = [3, 1]
[body.a.points]
O = [0.1, 0]
A = [1, 0.5]
[body.b.points]
A = [0.3, 0.2]
B = [0.3, 1]
[body.c.points]
B = [0, 0.2]
C = [1, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "a.O"]
[[joint]]
type = "revolute"
at = ["a.A", "b.A"]
[[joint]]
type = "revolute"
at = ["b.B", "c.B"]
[[joint]]
type = "gear"
bodies = ["a", "b"]
ratio = [-2, 3]
carrier = "c"
[[joint]]
type = "belt"
bodies = ["b", "c"]
radii = [1.5, 2.5]
crossed = true
carrier = "a"
[[joint]]
type = "rack"
at = ["a.A", "b.A"]
along = [1, 2]
radius = -0.7
phase = 0.4
name = "mesh"
[[joint]]
type = "cam"
at = ["b.A", "c.C"]
along = [2, -1]
carrier = "a"
phase = 0.3
profile = [[0, 1], [1, 2], [2.5, 1.4], [4, 0.3], [6.283185307179586, 1]]
name = "lobe"
[[joint]]
type = "cam-lever"
bodies = ["a", "c"]
carrier = "b"
profile = [[-1, 0.2], [1, 0.4], [2.5, 0.1], [4, -0.3], [5.283185307179586, 0.2]]
[[joint]]
type = "actuator"
at = ["a.A", "c.C"]
name = "lift"
[[driver]]
slide = "lift"
start = 1
velocity = 0.7
acceleration = 0.3
[[driver]]
slide = "mesh"
value = "sin(t)"
[[driver]]
slide = "lobe"
value = "cos(2*t)"
)toml";

TEST(Phi, JacobianAndAccelerationTermsOfTransmissionsMatchDifferences) {
  const Mechanism m = typed(kTransmissions);
  const Phi phi(m);
  EXPECT_EQ(phi.size(), 3 * 2 + 5 + 3);
  VectorXd q(phi.dimension()), qdot(phi.dimension());
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    q[k] = std::sin(1.3 * static_cast<double>(k));
    qdot[k] = std::cos(0.7 * static_cast<double>(k));
  }
  constexpr double kTime = 0.7, kStep = 1e-6, kAgreement = 1e-7;
  const auto along = [&](double s) { return phi.value(q + s * qdot, kTime); };
  const VectorXd slope = (along(kStep) - along(-kStep)) / (2 * kStep);
  EXPECT_LT((phi.jacobian(q, kTime) * qdot - slope).norm(), kAgreement);
  const auto velocity = [&](double s) {
    const VectorXd there = q + s * qdot;
    return VectorXd(phi.jacobian(there, kTime + s) * qdot + phi.partial_t(there, kTime + s));
  };
  const VectorXd bend = (velocity(kStep) - velocity(-kStep)) / (2 * kStep);
  EXPECT_LT((phi.acceleration_rhs(q, qdot, kTime) + bend).norm(), kAgreement);
}

TEST(Phi, SpatialJacobianAndAccelerationTermsMatchDifferences) {
  const Mechanism m = typed(kEverySpatialJoint);
  const Phi phi(m);
  EXPECT_EQ(phi.size(), 5 + 4 + 5 + 4 + 6 + 1 + 3 + 5 + 3 + 2 + 1 + 5);
  VectorXd q(phi.dimension()), qdot(phi.dimension());
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    q[k] = std::sin(1.3 * static_cast<double>(k));
    qdot[k] = std::cos(0.7 * static_cast<double>(k));
  }
  constexpr double kTime = 0.7, kStep = 1e-6, kAgreement = 1e-7;
  const auto along = [&](double s) { return phi.value(q + s * qdot, kTime); };
  const VectorXd slope = (along(kStep) - along(-kStep)) / (2 * kStep);
  EXPECT_LT((phi.jacobian(q, kTime) * qdot - slope).norm(), kAgreement);
  const auto velocity = [&](double s) {
    const VectorXd there = q + s * qdot;
    return VectorXd(phi.jacobian(there, kTime + s) * qdot + phi.partial_t(there, kTime + s));
  };
  const VectorXd bend = (velocity(kStep) - velocity(-kStep)) / (2 * kStep);
  EXPECT_LT((phi.acceleration_rhs(q, qdot, kTime) + bend).norm(), kAgreement);
}

TEST(Phi, AnglesThatDifferByWholeTurnsAreOnePose) {
  const Mechanism m = example("four-bar");
  const Phi phi(m);
  VectorXd q = initial_guess(m);
  const VectorXd value = phi.value(q, 0);
  q[2] += 4 * std::acos(-1.0);
  EXPECT_LT((phi.value(q, 0) - value).norm(), 1e-12);
}

TEST(Phi, CanonicalPoseIsTheSamePoseWithSmallAngles) {
  const Mechanism planar = example("four-bar");
  const Phi phi(planar);
  VectorXd q = initial_guess(planar);
  q[2] = 10;
  q[5] = -10;
  const VectorXd canonical = phi.canonical(q);
  EXPECT_LE(canonical.lpNorm<Eigen::Infinity>(), 100);
  EXPECT_NEAR(canonical[2], 10 - 4 * std::acos(-1.0), 1e-14);
  EXPECT_NEAR(canonical[5], -10 + 4 * std::acos(-1.0), 1e-14);
  EXPECT_LT((phi.value(canonical, 0) - phi.value(q, 0)).norm(), 1e-12);

  const Phi spatial(typed(kEverySpatialJoint));
  VectorXd p = VectorXd::LinSpaced(spatial.dimension(), -4, 5);
  const VectorXd small = spatial.canonical(p);
  EXPECT_LE(small.segment<3>(3).norm(), std::acos(-1.0) + 1e-15);
  const auto rows = static_cast<Eigen::Index>(spatial.size() - spatial.driver_size());
  const VectorXd difference = spatial.value(small, 0).cwiseAbs() - spatial.value(p, 0).cwiseAbs();
  EXPECT_LT(difference.head(rows).norm(), 1e-12);  // a quaternion's sign may turn tilt rows over
}

TEST(Phi, CanonicalPoseKeepsAnglesForWhichATurnIsAnotherPose) {
  const Mechanism m = typed(
      "[unknowns]\nangles = [\"half\", \"bare\", \"whole\", \"timed\"]\n[constants]\nthird = "
      "3\n[equations]\n"
      "a = \"cos(half/2) + sin(2*whole - pi)\"\n"
      "b = \"bare*cos(whole) + tan(third*whole/3 + t)\"\n"
      "c = \"sin(-(half + whole)) + cos(t*timed)\"\n[[driver]]\nunknown = \"half\"\nstart = 9\n");
  const Phi phi(m);
  const VectorXd q = VectorXd::Constant(4, 8.0);
  const VectorXd canonical = phi.canonical(q);
  EXPECT_DOUBLE_EQ(canonical[0], 8);
  EXPECT_DOUBLE_EQ(canonical[1], 8);
  EXPECT_NEAR(canonical[2], 8 - 2 * std::acos(-1.0), 1e-14);
  EXPECT_DOUBLE_EQ(canonical[3], 8);
  EXPECT_LT((phi.value(canonical, 0.3) - phi.value(q, 0.3)).norm(), 1e-12);
  // Nor does its driver take an angle a turn away for the one it asks for.
  EXPECT_DOUBLE_EQ(phi.value(VectorXd::Constant(4, 9 - 2 * std::acos(-1.0)), 0)[3],
                   -2 * std::acos(-1.0));
}

TEST(Phi, TermMagnitudesScaleTheResidual) {
  const Phi phi(typed("[unknowns]\nlengths = [\"x\"]\n[equations]\ne = \"1e6*x - 1e6\"\n"));
  const VectorXd q = VectorXd::Constant(1, 1 + 1e-12);
  EXPECT_NEAR(phi.term_magnitudes(q, 0)[0], 2e6, 1);
  EXPECT_NEAR(scaled_residual(phi, q, 0), 0.5e-12, 1e-15);
}

TEST(Phi, MagnitudesNearAZeroOfAFunctionAreThoseOfItsArgument) {
  const Phi phi(typed("[unknowns]\nangles = [\"a\"]\n[equations]\ne = \"sin(a)\"\n"));
  const VectorXd q = VectorXd::Constant(1, std::acos(-1.0));
  EXPECT_LT(scaled_residual(phi, q, 0), 1e-15);
}

TEST(Phi, WithoutDriversKeepsTheJointsRows) {
  const Phi phi(example("five-bar"));
  EXPECT_EQ(phi.size(), 12);
  EXPECT_EQ(phi.driver_size(), 2);
  const Phi joints = phi.without_drivers();
  EXPECT_EQ(joints.size(), 10);
  EXPECT_EQ(joints.driver_size(), 0);
  EXPECT_EQ(joints.row_names().back(), "revolute C: y");
  EXPECT_EQ(phi.row_names().back(), "driver crank2: angle");
}

TEST(Phi, GearTurnsBodiesInTheRatioOfTheirTeethAsSeenFromTheCarrier) {
  const Mechanism m = typed(R"toml(
[units]
angle = "deg"
[ground.points]
O = [0, 0]
[body.arm.points]
O = [0, 0]
P = [3, 0]
[body.sun.points]
O = [0, 0]
[body.planet.points]
P = [0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "arm.O"]
[[joint]]
type = "revolute"
at = ["ground.O", "sun.O"]
[[joint]]
type = "revolute"
at = ["arm.P", "planet.P"]
[[joint]]
type = "gear"
bodies = ["sun", "planet"]
ratio = [-20, 10]
carrier = "arm"
)toml");
  const Phi phi(m);
  EXPECT_EQ(phi.row_names().back(), "gear sun-planet: turn");
  VectorXd q = VectorXd::Zero(9);
  // The arm turns, the sun stands: seen from the arm the sun turns -30, the planet +60.
  q[2] = 30 * kDegree;
  q[8] = (60 + 30) * kDegree;
  EXPECT_NEAR(phi.value(q, 0)[6], 0, 1e-15);
  q[8] += 10 * kDegree;
  EXPECT_NEAR(std::abs(phi.value(q, 0)[6]), 10 * kDegree, 1e-14);
}

TEST(Phi, ObliqueLinesAndTurnsHoldWhereTheyAreMade) {
  const Mechanism m = typed(R"toml(
[units]
angle = "deg"
[ground.points]
G = [1, 2]
[body.slider.points]
P = [0.5, 0]
[body.block.points]
Q = [0, 0.25]
[body.plate.points]
Q = [3, 1]
[[joint]]
type = "prismatic"
at = ["ground.G", "slider.P"]
along = [3, 4]
turn = 30
[[joint]]
type = "slot"
at = ["slider.P", "block.Q"]
along = [1, 1]
[[joint]]
type = "weld"
at = ["block.Q", "plate.Q"]
turn = -20
)toml");
  const Phi phi(m);
  const auto turned = [](double angle_deg, double x, double y) {
    const double a = angle_deg * kDegree;
    return Eigen::Vector2d(std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y);
  };
  const Eigen::Vector2d P = Eigen::Vector2d(1, 2) + 0.7 * Eigen::Vector2d(3, 4);
  const Eigen::Vector2d Q = P - 1.3 * turned(30, 1, 1);
  VectorXd q(9);
  q << P - turned(30, 0.5, 0), 30 * kDegree, Q - turned(75, 0, 0.25), 75 * kDegree,
      Q - turned(55, 3, 1), 55 * kDegree;
  EXPECT_LT(phi.value(q, 0).norm(), 1e-14);
  for (Eigen::Index k = 0; k < 9; ++k) {
    VectorXd off = q;
    off[k] += 0.1;
    EXPECT_GT(phi.value(off, 0).norm(), 0.01)
        << phi.coordinates()[static_cast<std::size_t>(k)].name;
  }
  EXPECT_LT(phi.value(initial_guess(m), 0).norm(), 1e-14) << "guesses keep lines and turns";
}

TEST(Phi, SpatialWeldAndSliderHoldEveryTurn) {
  const Mechanism m = typed(R"toml(
space = "spatial"
[units]
angle = "deg"
[ground.points]
G = [1, 2, 3]
[body.slider.points]
P = [0.5, 0, 0]
[body.plate.points]
Q = [0, 0.25, 0]
[[joint]]
type = "prismatic"
at = ["slider.P", "ground.G"]
axis = [[0, 0, 1], [0, 1, 1]]
turn = 30
[[joint]]
type = "weld"
at = ["slider.P", "plate.Q"]
axis = [1, 2, 3]
turn = 40
)toml");
  const Phi phi(m);
  const VectorXd q = initial_guess(m);
  EXPECT_LT(phi.value(q, 0).norm(), 1e-14);
  for (Eigen::Index k = 0; k < phi.size(); ++k) {
    EXPECT_GT(phi.jacobian(q, 0).row(k).norm(), 0.1)
        << phi.row_names()[static_cast<std::size_t>(k)];
  }
}

TEST(Phi, FormulaWithAConstantExponentKeepsSigns) {
  const Phi phi(
      typed("[unknowns]\nlengths = [\"x\"]\n[equations]\ncube = \"x^3 - 2*x + x^(1+1) + 2\"\n"));
  const VectorXd q = VectorXd::Constant(1, -2.0);
  EXPECT_DOUBLE_EQ(phi.value(q, 0)[0], -8 + 4 + 4 + 2);
  EXPECT_DOUBLE_EQ(phi.jacobian(q, 0)(0, 0), 12 - 2 - 4);
}

TEST(Phi, EquationMayBeTypedWithAnEqualsSign) {
  const Phi phi(typed("[unknowns]\nlengths = [\"x\"]\n[equations]\ne = \"x^2 = 4\"\n"));
  EXPECT_DOUBLE_EQ(phi.value(VectorXd::Constant(1, 3.0), 0)[0], 5);
}

}  // namespace
}  // namespace moivre
