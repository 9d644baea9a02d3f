// SPDX-License-Identifier: MIT
// Do coordinates, constraints and drivers do what the course notes say? A test a page, named by it,
// with the page's numbers.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "files.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::example;
using test::kDegree;
using test::typed;

const std::string kThreeBodies = R"toml(
[ground.points]
O = [0, 0]
[body.a.points]
O = [0, 0]
A = [1, 0]
[body.b.points]
A = [0, 0]
B = [1, 0]
[body.c.points]
B = [0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "a.O"]
[[joint]]
type = "revolute"
at = ["a.A", "b.A"]
[[joint]]
type = "revolute"
at = ["b.B", "c.B"]
)toml";

const std::string kTwoSpatialBodies = R"toml(
space = "spatial"
[ground.points]
O = [0, 0, 0]
[body.a.points]
O = [0, 0, 0]
A = [1, 2, 3]
[body.b.points]
A = [0.5, 0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "a.O"]
axis = [0, 0, 1]
[[joint]]
type = "spherical"
at = ["a.A", "b.A"]
)toml";

/// Central difference quotient of f at s = 0.
template <class F>
VectorXd slope(const F& f) {
  constexpr double kStep = 1e-6;
  return (f(kStep) - f(-kStep)) / (2 * kStep);
}

TEST(SeedP02, CoordinatesHaveNamesAndACount) {
  const Phi phi(example("slider-crank-equations"));
  ASSERT_EQ(phi.dimension(), 3);
  EXPECT_EQ(phi.coordinates()[0].name, "phi1");
  EXPECT_EQ(phi.coordinates()[1].name, "phi2");
  EXPECT_EQ(phi.coordinates()[2].name, "d");
}

TEST(SeedP03, PlanarBodyTakesLocalPointsToTheGround) {
  const Mechanism m = typed(R"toml(
[ground.points]
O = [1, 2]
[body.i.points]
O = [0, 0]
P = [2, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "i.O"]
)toml");
  const Eigen::Vector3d r = point_position(m, {1, 1}, Eigen::Vector3d(1, 2, 30 * kDegree));
  EXPECT_NEAR(r.x(), 2.7320508, 5e-8);
  EXPECT_NEAR(r.y(), 3.0, 1e-15);
}

TEST(SeedP04, EverySpatialPoseIsARotationAndAgreesWithQuaternions) {
  const Mechanism m = typed(kTwoSpatialBodies);
  for (int sample = 0; sample < 50; ++sample) {
    const double size = 0.13 * sample;  // from no turn at all to beyond a whole one
    const Eigen::Vector3d v =
        size * Eigen::Vector3d(std::sin(3.0 * sample), 1, std::cos(sample)).normalized();
    VectorXd q = VectorXd::Zero(12);
    q.segment<3>(3) = v;
    const Eigen::Matrix3d R = orientation(m, 1, q);
    EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(R.determinant(), 1, 1e-14);
    const Eigen::Quaterniond quaternion(size == 0 ? Eigen::AngleAxisd::Identity()
                                                  : Eigen::AngleAxisd(size, v.normalized()));
    EXPECT_LT((R - quaternion.toRotationMatrix()).norm(), 1e-14);
  }
}

TEST(SeedP05, ThreePlanarBodiesHaveNineCoordinatesTwoSpatialOnesTwelve) {
  EXPECT_EQ(Phi(typed(kThreeBodies)).dimension(), 9);
  EXPECT_EQ(Phi(typed(kTwoSpatialBodies)).dimension(), 12);
}

TEST(SeedP06, CoordinatesAreStackedBodyByBody) {
  const Phi phi(typed(kThreeBodies));
  EXPECT_EQ(phi.coordinates()[4].name, "b.y");
  EXPECT_EQ(phi.coordinates()[4].group, 1U);
}

TEST(SeedP07, ThreeBodiesOnThreeRevolutesHaveThreeFreedoms) {
  const Phi phi(typed(kThreeBodies));
  EXPECT_EQ(phi.dimension() - phi.size(), 3);
}

TEST(SeedP08, RevoluteGivesTwoRowsInThePlaneAndFiveInSpace) {
  const Mechanism planar = typed(kThreeBodies);
  const Phi phi(planar);
  EXPECT_EQ(phi.size(), 3 * 2);
  EXPECT_EQ(phi.row_names()[0], "revolute O: x");
  EXPECT_EQ(phi.row_names()[1], "revolute O: y");
  EXPECT_LT(phi.value(initial_guess(planar), 0).norm(), 1e-15);
  const Mechanism spatial = typed(kTwoSpatialBodies);
  const Phi spatial_phi(spatial);
  EXPECT_EQ(spatial_phi.size(), 5 + 3);
  VectorXd q = initial_guess(spatial);
  q[5] = 0.7;  // turned about the axis z
  q.segment<3>(6) = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(1, 2, 3) -
                    Eigen::Vector3d(0.5, 0, 0);
  EXPECT_LT(spatial_phi.value(q, 0).norm(), 1e-15);
}

TEST(SeedP09, DriverIsAParabolaWithItsTimeDerivatives) {
  const Mechanism m = typed(R"toml(
[unknowns]
angles = ["phi"]
lengths = ["x"]
[equations]
follow = "x - cos(phi)"
[[driver]]
unknown = "phi"
start = 0.52359877559829887
velocity = 2
acceleration = 0.5
)toml");
  const Phi phi(m);
  const double target = 0.52359877559829887 + 2.25;
  EXPECT_NEAR(target, 2.7735988, 5e-8);
  EXPECT_NEAR(phi.value(Eigen::Vector2d(target, 0), 1)[1], 0, 1e-15);
  EXPECT_DOUBLE_EQ(phi.partial_t(Eigen::Vector2d(target, 0), 1)[1], -2.5);
  EXPECT_DOUBLE_EQ(phi.partial_tt(Eigen::Vector2d(target, 0), 1)[1], -0.5);
}

TEST(SeedP09, VelocityConstraintsAreRefusedWithTheReason) {
  try {
    typed("[unknowns]\nlengths = [\"x\", \"y\"]\n[equations]\nskate = \"x_dot - y\"\n");
    FAIL() << "a derivative must be refused";
  } catch (const ParseError& error) {
    EXPECT_EQ(error.diagnostics()[0].message,
              "'x_dot' looks like a derivative: a constraint on velocities (rolling, "
              "non-holonomic) does not say where the mechanism can be and is not supported; write "
              "constraints between coordinates");
    EXPECT_EQ(error.diagnostics()[0].at.line, 4U);
  }
}

TEST(SeedP10, OneSidedConstraintsAreRefusedWithTheReason) {
  try {
    typed("[unknowns]\nlengths = [\"x\"]\n[equations]\nfloor = \"x >= 0\"\n");
    FAIL() << "an inequality must be refused";
  } catch (const ParseError& error) {
    EXPECT_EQ(error.diagnostics()[0].message,
              "an inequality is a one-sided constraint (contact): it holds only at times and is "
              "not supported; write an equation, or 'limits' on a joint to filter closures");
  }
}

TEST(SeedP10, JointLimitsAreKeptToFilterClosures) {
  Mechanism m = example("four-bar");
  m.joints[2].limits = Limits{0, 90 * kDegree};
  VectorXd q = VectorXd::Zero(9);
  q[5] = 20 * kDegree;
  q[8] = 57 * kDegree;
  EXPECT_TRUE(is_within_limits(m, m.joints[2], q));
  q[8] = -98 * kDegree;
  EXPECT_FALSE(is_within_limits(m, m.joints[2], q));
  q[8] = (57 + 360) * kDegree;
  EXPECT_TRUE(is_within_limits(m, m.joints[2], q));
}

TEST(SeedP17, JacobianMatchesDifferencesForEveryExample) {
  constexpr double kAgreement = 1e-7;
  for (const char* name :
       {"four-bar", "slider-crank", "slider-crank-equations", "redundant-system", "gear-five-bar",
        "scotch-yoke", "whitworth", "3-rpr", "rssr", "bennett"}) {
    const Mechanism m = example(name);
    const Phi phi(m);
    VectorXd q = initial_guess(m);
    for (Index k = 0; k < q.size(); ++k) q[k] += 0.1 * std::sin(static_cast<double>(k) + 1);
    const double size = std::max(1.0, q.lpNorm<Eigen::Infinity>());
    const MatrixXd J = phi.jacobian(q, 0.3);
    for (Index k = 0; k < q.size(); ++k) {
      const VectorXd column =
          slope([&](double s) { return phi.value(q + s * VectorXd::Unit(q.size(), k), 0.3); });
      EXPECT_LT((J.col(k) - column).norm(), kAgreement * size) << name << " column " << k;
    }
  }
}

TEST(SeedP22, AccelerationTermsOfADriverThatMixesPlaceAndTime) {
  const Phi phi(typed(R"toml(
[unknowns]
lengths = ["x", "y"]
[constants]
w = 1.7
c = 0.4
[equations]
turning = "x*cos(w*t) + y*sin(w*t) - c"
circle = "x^2 + y^2 - 9"
)toml"));
  const Eigen::Vector2d q(1.3, -0.6);
  const VectorXd qdot = Eigen::Vector2d(0.9, 2.1);
  constexpr double kTime = 0.8;
  constexpr double kAgreement = 1e-8;
  const VectorXd Phi_t = slope([&](double s) { return phi.value(q, kTime + s); });
  EXPECT_LT((phi.partial_t(q, kTime) - Phi_t).norm(), kAgreement);
  const VectorXd Phi_tt = slope([&](double s) { return phi.partial_t(q, kTime + s); });
  EXPECT_LT((phi.partial_tt(q, kTime) - Phi_tt).norm(), kAgreement);
  const VectorXd mixed =
      2 * slope([&](double s) { return VectorXd(phi.jacobian(q, kTime + s) * qdot); });
  EXPECT_GT(mixed.norm(), 1) << "the example must have Phi_qt";
  EXPECT_LT((phi.mixed(q, qdot, kTime) - mixed).norm(), kAgreement);
  const VectorXd quadratic =
      slope([&](double s) { return VectorXd(phi.jacobian(q + s * qdot, kTime) * qdot); });
  EXPECT_LT((phi.quadratic(q, qdot, kTime) - quadratic).norm(), kAgreement);
  EXPECT_LT((phi.acceleration_rhs(q, qdot, kTime) + quadratic + mixed + Phi_tt).norm(),
            2 * kAgreement);
  constexpr double kRate = 1.3;
  const VectorXd along = quadratic + kRate * mixed + kRate * kRate * Phi_tt;
  EXPECT_LT((phi.second_derivative(q, qdot, kTime, kRate) - along).norm(), 4 * kAgreement);
  MatrixXd extended(2, 3);
  extended << phi.jacobian(q, kTime), Phi_t;
  EXPECT_LT((phi.extended_jacobian(q, kTime) - extended).norm(), kAgreement);
}

TEST(SeedP32, RightHandSidesAreMinusPhiTAndGamma) {
  const Mechanism m = example("four-bar");
  const Phi phi(m);
  const VectorXd q = initial_guess(m);
  const VectorXd qdot = VectorXd::LinSpaced(9, -1, 1);
  EXPECT_EQ(phi.velocity_rhs(q, 0.1), -phi.partial_t(q, 0.1));
  const VectorXd gamma =
      -(phi.quadratic(q, qdot, 0.1) + phi.mixed(q, qdot, 0.1) + phi.partial_tt(q, 0.1));
  EXPECT_LT((phi.acceleration_rhs(q, qdot, 0.1) - gamma).norm(), 1e-12 * gamma.norm());
}

TEST(SeedP33, GeneratedSliderCrankEqualsTheHandWrittenEquations) {
  const Mechanism m = example("slider-crank");
  const Phi generated(m);
  const Phi typed_by_hand(example("slider-crank-equations"));
  for (const double phi2 : {0.3, 2.0, -1.1}) {
    const double phi1 = 0.4, d = 7.7;
    // Every body placed by the angles, so that only the loop stays open.
    VectorXd q = VectorXd::Zero(9);
    q[2] = phi1;
    q.segment<3>(3) << 10 * std::cos(phi1), 10 * std::sin(phi1), phi2;
    q.segment<3>(6) << d, 4, 0;
    const VectorXd rows = generated.value(q, 0);
    const VectorXd by_hand = typed_by_hand.value(Eigen::Vector3d(phi1, phi2, d), 0);
    EXPECT_LT(rows.head(4).norm(), 1e-14);
    EXPECT_NEAR(rows[4], by_hand[0], 1e-14);  // coupler.B - slider.B: x
    EXPECT_NEAR(rows[5], by_hand[1], 1e-14);  // and y
  }
}

TEST(SeedP33, GeneratedFourBarEqualsTheHandWrittenEquations) {
  const Phi generated(example("four-bar"));
  const double phi1 = 0.7, phi2 = 0.2, phi3 = 1.3;
  VectorXd q = VectorXd::Zero(9);
  q[2] = phi1;
  q.segment<3>(3) << 40 * std::cos(phi1), 40 * std::sin(phi1), phi2;
  q.segment<3>(6) << 100, 0, phi3;
  const VectorXd rows = generated.value(q, 0);
  EXPECT_NEAR(rows[4], 40 * std::cos(phi1) + 120 * std::cos(phi2) - 80 * std::cos(phi3) - 100,
              1e-13);
  EXPECT_NEAR(rows[5], 40 * std::sin(phi1) + 120 * std::sin(phi2) - 80 * std::sin(phi3), 1e-13);
}

}  // namespace
}  // namespace moivre
