// SPDX-License-Identifier: MIT
// Do solves, velocities, accelerations, ranks and null spaces meet the course notes? A test a page,
// with the page's numbers.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

#include "../mechanism/files.h"
#include "moivre/factorization/svd.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/kinematics/null_space.h"
#include "moivre/kinematics/state.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::example;
using test::kDegree;
using test::typed;

constexpr double kSixDigits = 5e-7;  // half a unit of the sixth printed decimal

/// The four-bar of p15 as its three angles' loop equations, crank driven at 40 degrees, omega = 25,
/// alpha = 15.
Mechanism four_bar_equations() {
  return typed(R"toml(
[unknowns]
angles = ["phi1", "phi2", "phi3"]
[equations]
horizontal = "40*cos(phi1) + 120*cos(phi2) - 80*cos(phi3) - 100"
vertical = "40*sin(phi1) + 120*sin(phi2) - 80*sin(phi3)"
[[driver]]
unknown = "phi1"
start = 0.69813170079773183
velocity = 25
acceleration = 15
)toml");
}

VectorXd closure_of(const Phi& phi, const VectorXd& guess) {
  const NewtonResult run = newton(phi, guess);
  EXPECT_EQ(run.status, NewtonStatus::converged) << run.message;
  return run.q;
}

VectorXd open_closure(const Phi& phi) { return closure_of(phi, Vector3d(40, 20, 57) * kDegree); }

VectorXd crossed_closure(const Phi& phi) {
  return closure_of(phi, Vector3d(40, -61, -98) * kDegree);
}

/// A x = b typed as equations; A is 3 x 2 of p35.
Mechanism linear_system() {
  return typed(R"toml(
[unknowns]
lengths = ["x", "y"]
[equations]
e1 = "2*x + y - 3"
e2 = "x - 1"
e3 = "x + 0*y - 2"
)toml");
}

MatrixXd A35() { return MatrixXd{{2, 1}, {1, 0}, {1, 0}}; }
MatrixXd A48() { return MatrixXd{{1, 0, 1}, {5, 4, 9}, {2, 4, 6}}; }

VectorXd single_unknown(double x) { return VectorXd::Constant(1, x); }

std::vector<double> iterates(const NewtonResult& run) {
  std::vector<double> values;
  for (const NewtonIteration& row : run.iterations) values.push_back(row.q[0]);
  return values;
}

TEST(SeedP11, DoubleParallelCrankMovesThoughTheNaiveCountIsZero) {
  const Mechanism m = example("double-parallel-crank");
  const Phi phi(m);
  const Mobility at60 = mobility(phi, closure_of(phi, initial_guess(m)));
  EXPECT_EQ(at60.coordinates, 12);
  EXPECT_EQ(at60.constraints, 12);
  EXPECT_EQ(at60.gruebler, 0);
  EXPECT_EQ(at60.rank, 11);
  EXPECT_EQ(at60.rank_by_svd, 11);
  EXPECT_EQ(at60.degrees_of_freedom, 1);
  EXPECT_FALSE(at60.is_singular);
}

/// The double parallel crank, assembled with cranks at that angle.
VectorXd parallel_pose(double crank_rad) {
  VectorXd q = VectorXd::Zero(12);
  q.segment<3>(0) << 0, 0, crank_rad;
  q.segment<3>(3) << 3, 0, crank_rad;
  q.segment<3>(6) << 6, 0, crank_rad;
  q.segment<3>(9) << 2 * std::cos(crank_rad), 2 * std::sin(crank_rad), 0;
  return q;
}

TEST(SeedP11, RankDropsToTenWhereTheCranksLieInLine) {
  const Phi phi(example("double-parallel-crank"));
  for (const double crank_deg : {0.0, 180.0}) {
    const Mobility m = mobility(phi, parallel_pose(crank_deg * kDegree));
    EXPECT_EQ(m.rank, 10) << crank_deg;
    EXPECT_TRUE(m.is_singular) << crank_deg;
    EXPECT_EQ(m.rank_nearby, 11) << crank_deg;
    ASSERT_FALSE(m.warnings.empty());
    EXPECT_TRUE(m.warnings[0].starts_with("singular pose: rank 10 here, 11 next to it; "))
        << m.warnings[0];
  }
  EXPECT_EQ(mobility(phi, parallel_pose(90 * kDegree)).rank, 11);
}

TEST(SeedP11, WithoutItsMiddleCrankTheNaiveCountIsRight) {
  Mechanism m = example("double-parallel-crank");
  // Fig. 3.8(b): bodies crank1, crank3 and coupler.
  m.bodies.erase(m.bodies.begin() + 2);
  std::erase_if(m.guess, [](const auto& given) { return given.first.starts_with("crank2."); });
  m.joints.erase(m.joints.begin() + 4);
  m.joints.erase(m.joints.begin() + 1);
  for (Joint& joint : m.joints) {
    for (PointOf& end : joint.at) end.body -= end.body > 2 ? 1 : 0;
  }
  const Phi phi(m);
  VectorXd q(9);
  const VectorXd full = parallel_pose(60 * kDegree);
  q << full.head(3), full.segment(6, 3), full.tail(3);
  EXPECT_LT(phi.without_drivers().value(q, 0).norm(), 1e-14);
  const Mobility b = mobility(phi, q);
  EXPECT_EQ(b.coordinates, 9);
  EXPECT_EQ(b.constraints, 8);
  EXPECT_EQ(b.rank, 8);
  EXPECT_EQ(b.degrees_of_freedom, 1);
}

TEST(SeedP12, SixEquationsInFiveCoordinatesHaveRankFour) {
  const Mechanism m = example("redundant-system");
  const Phi phi(m);
  const Mobility mob = mobility(phi, closure_of(phi, initial_guess(m)));
  EXPECT_EQ(mob.coordinates, 5);
  EXPECT_EQ(mob.constraints, 6);
  EXPECT_EQ(mob.rank, 4);
  EXPECT_EQ(mob.rank_by_svd, 4);
  EXPECT_EQ(mob.degrees_of_freedom, 1);
  // Phi1 = Phi3 + Phi5 and Phi2 = Phi4 + Phi6, each solved for its last row.
  ASSERT_EQ(mob.redundant.size(), 2U);
  EXPECT_EQ(to_text(mob.redundant[0]), "Phi5 = [Phi1] - [Phi3]");
  EXPECT_EQ(to_text(mob.redundant[1]), "Phi6 = [Phi2] - [Phi4]");
}

/// q = (phi1, phi2, l1, l2, l3) of p12, with its driver at phi1_deg.
VectorXd redundant_closure(double phi1_deg, double phi2_deg, double l1) {
  Mechanism m = example("redundant-system");
  m.drivers[0].law = Parabola{phi1_deg * kDegree, 0, 0};
  VectorXd guess(5);
  guess << phi1_deg * kDegree, phi2_deg * kDegree, l1, 4, 4;
  return closure_of(Phi(m), guess);
}

TEST(SeedP12, ClosuresAt30And60Degrees) {
  const auto expect = [](const VectorXd& q, double l1, double phi2_deg, double l2, double l3) {
    EXPECT_NEAR(q[2], l1, kSixDigits);
    EXPECT_NEAR(q[1] / kDegree, phi2_deg, 5e-6);
    EXPECT_NEAR(q[3], l2, kSixDigits);
    EXPECT_NEAR(q[4], l3, kSixDigits);
  };
  expect(redundant_closure(30, 35, 1.8), 2, 30, 5.196152, 3);
  expect(redundant_closure(30, -140, -1.8), -2, -150, 5.196152, 3);
  expect(redundant_closure(60, 30, 3.5), 3.573518, 26.69895, 3, 5.196152);
  expect(redundant_closure(60, -80, 0.3), 0.230329, -86.69895, 3, 5.196152);
}

TEST(SeedP13, DependentRowsAreCountedNamedAndAgreeWithTheSvd) {
  const Mechanism m = example("double-parallel-crank");
  const Phi phi(m);
  const Mobility one = mobility(phi, parallel_pose(60 * kDegree));
  ASSERT_EQ(one.redundant.size(), 1U);
  EXPECT_EQ(one.redundant[0].name, "revolute A3: y");
  EXPECT_EQ(one.left_null_space.cols(), 1);
  // The combination holds for the rows of Phi_q.
  const MatrixXd J = phi.without_drivers().jacobian(parallel_pose(60 * kDegree), 0);
  VectorXd sum = VectorXd::Zero(12);
  for (const RowShare& share : one.redundant[0].combination) {
    sum += share.coefficient * J.row(share.row).transpose();
  }
  EXPECT_LT((sum - J.row(one.redundant[0].row).transpose()).norm(), 1e-13);
  const Mechanism two = example("redundant-system");
  EXPECT_EQ(mobility(Phi(two), closure_of(Phi(two), initial_guess(two))).redundant.size(), 2U);
}

TEST(SeedP14, BothMethodsAgreeInPositionVelocityAndAcceleration) {
  for (const char* name :
       {"four-bar", "slider-crank", "watt-1", "stephenson-3", "whitworth", "jansen-leg", "five-bar",
        "gear-five-bar", "double-parallel-crank", "redundant-system", "rssr", "bennett"}) {
    const Mechanism m = example(name);
    const Phi phi(m);
    const Phi joints = phi.without_drivers();
    const VectorXd q = closure_of(phi, initial_guess(m));
    const MotionState appended = motion_state(phi, q, 0);
    EXPECT_TRUE(appended.is_determined) << name;
    const Partition partition = choose_partition(joints, q);
    ASSERT_TRUE(partition.is_usable()) << name << ": " << partition.refusal;
    VectorXd guess = q;
    for (const Index k : partition.dependent) guess[k] += 1e-3;
    const NewtonResult positions = solve_positions(joints, partition, guess);
    EXPECT_EQ(positions.status, NewtonStatus::converged) << name;
    EXPECT_LT((positions.q - q).norm(), 1e-11 * std::max(1.0, q.norm())) << name;
    const MotionState partitioned =
        partitioned_state(joints, partition, q, appended.velocity(partition.independent),
                          appended.acceleration(partition.independent));
    EXPECT_LT((partitioned.velocity - appended.velocity).norm(),
              1e-12 * (1 + appended.velocity.norm()))
        << name;
    EXPECT_LT((partitioned.acceleration - appended.acceleration).norm(),
              1e-11 * (1 + appended.acceleration.norm()))
        << name;
  }
}

TEST(SeedP15, FourBarClosures) {
  const Phi phi(four_bar_equations());
  EXPECT_EQ(phi.without_drivers().size(), 2);
  EXPECT_EQ(phi.dimension(), 3);
  EXPECT_EQ(mobility(phi, open_closure(phi)).degrees_of_freedom, 1);
  constexpr double kFourDigits = 5e-5;
  EXPECT_NEAR(open_closure(phi)[1] / kDegree, 20.2979, kFourDigits);
  EXPECT_NEAR(open_closure(phi)[2] / kDegree, 57.3249, kFourDigits);
  EXPECT_NEAR(crossed_closure(phi)[1] / kDegree, -60.9780, kFourDigits);
  EXPECT_NEAR(crossed_closure(phi)[2] / kDegree, -98.0050, kFourDigits);
}

TEST(SeedP16, EveryUsableChoiceOfVGivesTheSameClosure) {
  const Phi phi(four_bar_equations());
  const Phi joints = phi.without_drivers();
  const VectorXd q = open_closure(phi);
  for (const Index v : {0, 1, 2}) {
    const Partition partition = make_partition(joints, q, {v});
    ASSERT_TRUE(partition.is_usable());
    VectorXd guess = q;
    for (const Index u : partition.dependent) guess[u] += 0.05;
    EXPECT_LT((solve_positions(joints, partition, guess).q - q).norm(), 1e-12);
  }
  const Partition chosen = choose_partition(joints, q);
  EXPECT_TRUE(chosen.is_usable());
  EXPECT_EQ(chosen.independent.size(), 1U);
}

TEST(SeedP16, ChoiceThatMakesPhiUSingularIsRefused) {
  const Phi joints = Phi(four_bar_equations()).without_drivers();
  // Crank and coupler in line, 160 from O2 to B: the rocker stands at its limit and cannot be
  // prescribed.
  const double rocker = std::acos((100.0 * 100 + 80 * 80 - 160 * 160) / (2 * 100 * 80));
  const double line = std::acos((100.0 * 100 + 160 * 160 - 80 * 80) / (2 * 100 * 160));
  const Vector3d q(line, line, std::acos(-1.0) - rocker);
  ASSERT_LT(joints.value(q, 0).norm(), 1e-12);
  const Partition refused = make_partition(joints, q, {2});
  EXPECT_FALSE(refused.is_usable());
  EXPECT_EQ(refused.refusal, "Phi_u is singular: phi3 cannot be chosen freely at this pose");
  EXPECT_TRUE(make_partition(joints, q, {0}).is_usable());
  EXPECT_TRUE(choose_partition(joints, q).is_usable());
  EXPECT_TRUE(make_partition(joints, q, {0, 1})
                  .refusal.starts_with("2 independent coordinates were chosen, "));
}

TEST(SeedP17, DifferentialOfPhiIsPhiQDq) {
  const Phi phi(four_bar_equations());
  const VectorXd q = open_closure(phi);
  const VectorXd dq = 1e-6 * Vector3d(1, -2, 3);
  const VectorXd difference = (phi.value(q + dq, 0) - phi.value(q - dq, 0)) / 2;
  EXPECT_LT((difference - phi.jacobian(q, 0) * dq).norm() / dq.norm(), 1e-7);
}

TEST(SeedP18, FourBarVelocitiesFromTheCrank) {
  const Phi phi(four_bar_equations());
  const Phi joints = phi.without_drivers();
  const auto velocities = [&](const VectorXd& q) {
    const Partition crank = make_partition(joints, q, {0});
    return partitioned_state(joints, crank, q, single_unknown(25), single_unknown(15)).velocity;
  };
  EXPECT_NEAR(velocities(open_closure(phi))[1], -4.120914, kSixDigits);
  EXPECT_NEAR(velocities(open_closure(phi))[2], 6.997985, kSixDigits);
  EXPECT_NEAR(velocities(crossed_closure(phi))[1], -9.258772, kSixDigits);
  EXPECT_NEAR(velocities(crossed_closure(phi))[2], -20.377672, kSixDigits);
}

TEST(SeedP19, FourBarAccelerationsFromTheCrank) {
  const Phi phi(four_bar_equations());
  const Phi joints = phi.without_drivers();
  const auto accelerations = [&](const VectorXd& q) {
    const Partition crank = make_partition(joints, q, {0});
    return partitioned_state(joints, crank, q, single_unknown(25), single_unknown(15)).acceleration;
  };
  EXPECT_NEAR(accelerations(open_closure(phi))[1], 296.089193, kSixDigits);
  EXPECT_NEAR(accelerations(open_closure(phi))[2], 470.133530, kSixDigits);
  EXPECT_NEAR(accelerations(crossed_closure(phi))[1], 597.622400, kSixDigits);
  EXPECT_NEAR(accelerations(crossed_closure(phi))[2], 423.578063, kSixDigits);
}

TEST(SeedP20, AppendedDriversMakeASquareSystemWithTheSameClosures) {
  const Mechanism bodies = example("four-bar");
  const Phi phi(bodies);
  EXPECT_EQ(phi.size(), phi.dimension());
  const NewtonResult run = newton(phi, initial_guess(bodies));
  EXPECT_EQ(run.iterations[0].method, LinearMethod::lu);
  const VectorXd angles = open_closure(Phi(four_bar_equations()));
  EXPECT_NEAR(run.q[5], angles[1], 1e-14);
  EXPECT_NEAR(run.q[8], angles[2], 1e-14);
}

TEST(SeedP21, AppendedVelocities) {
  const Phi phi(four_bar_equations());
  const MotionState open = motion_state(phi, open_closure(phi), 0);
  EXPECT_NEAR(open.velocity[0], 25, 1e-13);
  EXPECT_NEAR(open.velocity[1], -4.120914, kSixDigits);
  EXPECT_NEAR(open.velocity[2], 6.997985, kSixDigits);
  const MotionState crossed = motion_state(phi, crossed_closure(phi), 0);
  EXPECT_NEAR(crossed.velocity[1], -9.258772, kSixDigits);
  EXPECT_NEAR(crossed.velocity[2], -20.377672, kSixDigits);
}

TEST(SeedP22, AccelerationHoldsForADriverThatMixesPlaceAndTime) {
  // A point on a circle, on a turning line: x(t) by Newton at each t, its differences against q''.
  const Phi phi(typed(R"toml(
[unknowns]
lengths = ["x", "y"]
[equations]
turning = "x*cos(1.7*t) + y*sin(1.7*t) - 0.4"
circle = "x^2 + y^2 - 9"
)toml"));
  const auto place = [&](double t) {
    const NewtonResult run = newton(phi, Eigen::Vector2d(-3, 0.5), t);
    EXPECT_EQ(run.status, NewtonStatus::converged);
    return run.q;
  };
  constexpr double kTime = 0.8, kStep = 1e-4, kAgreement = 1e-6;
  const VectorXd q = place(kTime);
  const MotionState state = motion_state(phi, q, kTime);
  const VectorXd velocity = (place(kTime + kStep) - place(kTime - kStep)) / (2 * kStep);
  const VectorXd acceleration =
      (place(kTime + kStep) - 2 * q + place(kTime - kStep)) / (kStep * kStep);
  EXPECT_LT((state.velocity - velocity).norm(), kAgreement);
  EXPECT_LT((state.acceleration - acceleration).norm(), kAgreement);
}

TEST(SeedP23, AppendedAccelerations) {
  const Phi phi(four_bar_equations());
  const MotionState open = motion_state(phi, open_closure(phi), 0);
  EXPECT_NEAR(open.acceleration[0], 15, 1e-12);
  EXPECT_NEAR(open.acceleration[1], 296.089193, kSixDigits);
  EXPECT_NEAR(open.acceleration[2], 470.133530, kSixDigits);
  const MotionState crossed = motion_state(phi, crossed_closure(phi), 0);
  EXPECT_NEAR(crossed.acceleration[1], 597.622400, kSixDigits);
  EXPECT_NEAR(crossed.acceleration[2], 423.578063, kSixDigits);
}

Mechanism one_equation(const std::string& text) {
  return typed("[unknowns]\nlengths = [\"x\"]\n[equations]\ne = \"" + text + "\"\n");
}

TEST(SeedP24, NewtonStepIsPhiOverItsDerivative) {
  const NewtonResult run = newton(Phi(one_equation("x^2 - 2")), single_unknown(1));
  EXPECT_DOUBLE_EQ(iterates(run)[1], 1 - (1.0 - 2) / 2);
  EXPECT_NEAR(run.q[0], std::sqrt(2.0), 1e-15);
}

TEST(SeedP25, CycleIsDetected) {
  const NewtonResult run = newton(Phi(one_equation("x^3 - 2*x + 2")), single_unknown(0));
  EXPECT_EQ(run.status, NewtonStatus::cycling);
  EXPECT_EQ(run.cycle_length, 2);
  const std::vector<double> x = iterates(run);
  ASSERT_GE(x.size(), 3U);
  EXPECT_EQ(x[0], 0);
  EXPECT_EQ(x[1], 1);
  EXPECT_EQ(x[2], 0);
}

TEST(SeedP26, SquareRootOfFourFromTen) {
  NewtonOptions options;
  options.residual_tolerance = 1e-6;
  options.maximum_iterations = 1000;
  const NewtonResult run = newton(Phi(one_equation("x^2 - 4")), single_unknown(10), 0, options);
  const std::vector<double> x = iterates(run);
  const std::vector<double> printed{10, 5.2, 2.984615, 2.162411, 2.006099, 2.0000093, 2.0};
  ASSERT_EQ(x.size(), printed.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    EXPECT_NEAR(x[k], printed[k], k == 5 ? 5e-8 : kSixDigits);
  EXPECT_EQ(run.status, NewtonStatus::converged);
}

TEST(SeedP27, TwoByTwoNewtonStepSolvesTheJacobian) {
  const Phi phi(typed(R"toml(
[unknowns]
lengths = ["x", "y"]
[equations]
circle = "x^2 + y^2 - 25"
hyperbola = "x*y - 12"
)toml"));
  const Eigen::Vector2d guess(5, 2);
  const NewtonResult run = newton(phi, guess);
  const Eigen::Matrix2d J = (Eigen::Matrix2d() << 10, 4, 2, 5).finished();
  const Eigen::Vector2d step = J.inverse() * Eigen::Vector2d(25 - 29, 12 - 10);
  EXPECT_LT((run.iterations[1].q - guess - step).norm(), 1e-14);
  EXPECT_NEAR(run.q[0], 4, 1e-14);
  EXPECT_NEAR(run.q[1], 3, 1e-14);
}

TEST(SeedP28, NByNNewtonConvergesOnNineCoordinates) {
  const Mechanism m = example("slider-crank");
  const NewtonResult run = newton(Phi(m), initial_guess(m));
  EXPECT_EQ(run.status, NewtonStatus::converged);
  EXPECT_NEAR(run.q[6], 10.3923048, 5e-8);
}

/// Example 3.13 typed as on the slides; q = (phi1, phi2, d).
VectorXd slider_closure(double phi2, double d) {
  return closure_of(Phi(example("slider-crank-equations")), Vector3d(30 * kDegree, phi2, d));
}

TEST(SeedP29, IteratesOfExample313) {
  const NewtonResult run =
      newton(Phi(example("slider-crank-equations")), Vector3d(30 * kDegree, 5.59, 10));
  const double printed[][2] = {
      {5.59, 10}, {5.770692, 10.429604}, {5.759621, 10.392446}, {5.759587, 10.392305}};
  ASSERT_GE(run.iterations.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(run.iterations[k].q[1], printed[k][0], kSixDigits) << k;
    EXPECT_NEAR(run.iterations[k].q[2], printed[k][1], kSixDigits) << k;
  }
}

TEST(SeedP29, BothClosuresOfExample313) {
  EXPECT_NEAR(slider_closure(5.59, 10)[1] / kDegree, 330, 1e-12);
  EXPECT_NEAR(slider_closure(5.59, 10)[2], 6 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(slider_closure(3.5, 7)[1] / kDegree, 210, 1e-12);
  EXPECT_NEAR(slider_closure(3.5, 7)[2], 4 * std::sqrt(3.0), 1e-14);
}

TEST(SeedP29, VelocitiesAndAccelerationsOfExample313) {
  const Phi phi(example("slider-crank-equations"));
  const MotionState right = motion_state(phi, slider_closure(5.59, 10), 0);
  EXPECT_NEAR(right.velocity[1], -5, 1e-13);
  EXPECT_NEAR(right.velocity[2], -10, 1e-13);
  EXPECT_NEAR(right.acceleration[1], -11.547005, kSixDigits);
  EXPECT_NEAR(right.acceleration[2], -63.508530, kSixDigits);
  const MotionState left = motion_state(phi, slider_closure(3.5, 7), 0);
  EXPECT_NEAR(left.velocity[1], 5, 1e-13);
  EXPECT_NEAR(left.velocity[2], 0, 1e-13);
  EXPECT_NEAR(left.acceleration[1], 11.547005, kSixDigits);
  EXPECT_NEAR(left.acceleration[2], 46.188022, kSixDigits);
}

TEST(SeedP32, OneFactorizationServesVelocityAndAcceleration) {
  const Phi phi(four_bar_equations());
  const VectorXd q = open_closure(phi);
  EXPECT_EQ(motion_state(phi, q, 0).factorizations, 1);
  const Phi joints = phi.without_drivers();
  const Partition crank = make_partition(joints, q, {0});
  EXPECT_EQ(
      partitioned_state(joints, crank, q, single_unknown(25), single_unknown(15)).factorizations,
      1);
}

TEST(SeedP34, NormalEquationsSolveTheRedundantSystemInFourSteps) {
  const Mechanism m = example("redundant-system");
  NewtonOptions options;
  options.linear.method = LinearMethod::normal_equations;
  const Phi phi(m);
  const NewtonResult run = newton(phi, initial_guess(m), 0, options);
  EXPECT_EQ(run.status, NewtonStatus::converged);
  ASSERT_EQ(run.steps(), 4);
  EXPECT_GT(phi.value(run.iterations[3].q, 0).norm(), 1e-12);  // the notes' tolerance, on |Phi|
  EXPECT_LT(phi.value(run.iterations[4].q, 0).norm(), 1e-12);
  EXPECT_EQ(run.iterations[0].method, LinearMethod::normal_equations);
  EXPECT_NEAR(run.q[2], 2, 1e-12);
  EXPECT_NEAR(run.q[1], 30 * kDegree, 1e-12);
  EXPECT_NEAR(run.q[3], 5.196152, kSixDigits);
  EXPECT_NEAR(run.q[0], 30 * kDegree, 1e-12);
  EXPECT_NEAR(run.q[4], 3, 1e-12);
}

TEST(SeedP34, NormalEquationsWithoutFullColumnRankSayThatTheyWereReplaced) {
  const Factorization factors(A48(), {LinearMethod::normal_equations, {}});
  EXPECT_EQ(factors.method(), LinearMethod::svd);
  EXPECT_EQ(factors.rank(), 2);
}

TEST(SeedP35, LeastSquaresSolution) {
  const Vector3d b(3, 1, 2);
  for (const LinearMethod method :
       {LinearMethod::normal_equations, LinearMethod::qr, LinearMethod::svd}) {
    const VectorXd x = Factorization(A35(), {method, {}}).solve(b);
    EXPECT_NEAR(x[0], 1.5, 1e-14) << to_string(method);
    EXPECT_NEAR(x[1], 0, 1e-14) << to_string(method);
    EXPECT_NEAR((A35() * x - b).norm(), 0.707107, kSixDigits) << to_string(method);
  }
  const NewtonResult run = newton(Phi(linear_system()), Eigen::Vector2d(0, 0));
  EXPECT_EQ(run.status, NewtonStatus::no_solution);
  EXPECT_NEAR(run.q[0], 1.5, 1e-13);
}

TEST(SeedP36, WeightedMinimumNormStep) {
  const Phi phi(typed(R"toml(
[unknowns]
lengths = ["x", "y", "z"]
[equations]
sphere = "x^2 + y^2 + z^2 - 4"
)toml"));
  const Vector3d q(2, 1, 2);
  const NewtonResult plain = newton(phi, q);
  EXPECT_EQ(plain.iterations[0].method, LinearMethod::minimum_norm);
  EXPECT_LT((plain.iterations[1].q - q - Vector3d(-0.555556, -0.277778, -0.555556))
                .lpNorm<Eigen::Infinity>(),
            kSixDigits);
  NewtonOptions options;
  options.linear.weights = Vector3d(1, 2, 4);
  const NewtonResult weighted = newton(phi, q, 0, options);
  EXPECT_LT((weighted.iterations[1].q - q - Vector3d(-0.909091, -0.227273, -0.227273))
                .lpNorm<Eigen::Infinity>(),
            kSixDigits);
}

TEST(SeedP37, QrOfASquareSystemEqualsLu) {
  const MatrixXd A = (MatrixXd(3, 3) << 4, 1, -2, 0.5, 3, 1, 2, -1, 5).finished();
  const Vector3d b(1, 2, 3);
  const VectorXd by_lu = Factorization(A).solve(b);
  EXPECT_EQ(Factorization(A).method(), LinearMethod::lu);
  EXPECT_LT((Factorization(A, {LinearMethod::qr, {}}).solve(b) - by_lu).norm(), 1e-15);
}

TEST(SeedP38, QrOfATallSystemIsTheLeastSquaresSolution) {
  const Factorization factors(A35());
  EXPECT_EQ(factors.method(), LinearMethod::qr);
  EXPECT_LT((factors.solve(Vector3d(3, 1, 2)) - Eigen::Vector2d(1.5, 0)).norm(), 1e-14);
}

TEST(SeedP39, SvdGivesTheMinimumNormWhereTheRankIsDeficient) {
  const Factorization factors(A48());
  EXPECT_EQ(factors.method(), LinearMethod::svd);
  const Vector3d b = A48() * Vector3d(1, 2, 3);
  const VectorXd x = factors.solve(b);
  EXPECT_LT((A48() * x - b).norm(), 1e-13);
  EXPECT_NEAR(x.dot(Vector3d(-1, -1, 1)), 0, 1e-13);  // nothing along the null vector
}

TEST(SeedP40, EigenvaluesAndVectorsOfATransposeA) {
  const MatrixXd AtA = A35().transpose() * A35();
  EXPECT_EQ(AtA, (MatrixXd(2, 2) << 6, 2, 2, 1).finished());
  const auto [U, sigma, V] = svd(A35(), SingularVectors::thin);
  EXPECT_LT((AtA * V - V * sigma.cwiseAbs2().asDiagonal()).norm(), 1e-14);
  constexpr double kFourDigits = 5e-5;
  EXPECT_NEAR(sigma[1] * sigma[1], 0.2984, kFourDigits);
  EXPECT_NEAR(sigma[0] * sigma[0], 6.7016, kFourDigits);
  EXPECT_NEAR(std::abs(V(0, 1)), 0.3310, kFourDigits);
  EXPECT_NEAR(std::abs(V(1, 1)), 0.9436, kFourDigits);
}

TEST(SeedP41, SingularValuesAndTheThirdLeftVector) {
  const VectorXd sigma = singular_values(A35());
  constexpr double kFourDigits = 5e-5;
  EXPECT_NEAR(sigma[0], 2.5887, kFourDigits);
  EXPECT_NEAR(sigma[1], 0.5463, kFourDigits);
  const MatrixXd b3 = left_null_space(A35());
  ASSERT_EQ(b3.cols(), 1);
  EXPECT_NEAR(b3(0, 0), 0, 1e-15);
  EXPECT_NEAR(std::abs(b3(2, 0)), 0.7071, kFourDigits);
  EXPECT_NEAR(b3(1, 0), -b3(2, 0), 1e-15);
}

TEST(SeedP42, SvdMultipliesBackToA) {
  const auto [U, sigma, V] = svd(A35(), SingularVectors::full);
  MatrixXd S = MatrixXd::Zero(3, 2);
  S.diagonal() = sigma;
  EXPECT_LT((U * S * V.transpose() - A35()).norm(), 1e-12);
  EXPECT_LT((U.transpose() * U - MatrixXd::Identity(3, 3)).norm(), 1e-14);
}

TEST(SeedP43, ThePrintedUIsOrthogonalOnlyWithTheSignOfItsLastEntryPutRight) {
  const MatrixXd U = svd(A35(), SingularVectors::full).U;
  const VectorXd b3 = U.col(2) * (U(1, 2) > 0 ? -1 : 1);
  EXPECT_NEAR(b3[1], -0.7071, 5e-5);
  EXPECT_NEAR(b3[2], +0.7071, 5e-5);
  const VectorXd printed = Vector3d(b3[0], b3[1], -b3[2]);
  EXPECT_LT(std::abs(b3.dot(U.col(0))), 1e-15);
  EXPECT_GT(std::abs(printed.dot(U.col(0))), 0.5);
}

TEST(SeedP44, LeftNullVectorsAreTheRedundancyVectors) {
  EXPECT_LT((left_null_space(A35()).transpose() * A35()).norm(), 1e-15);
  const Phi phi(example("double-parallel-crank"));
  const Mobility m = mobility(phi, parallel_pose(60 * kDegree));
  const MatrixXd J = phi.without_drivers().jacobian(parallel_pose(60 * kDegree), 0);
  ASSERT_EQ(m.left_null_space.cols(), 1);
  EXPECT_LT((m.left_null_space.transpose() * J).norm(), 1e-14);
  // The vector and the named combination are one direction: c = (combination, -1 at the redundant
  // row).
  VectorXd c = VectorXd::Zero(12);
  c[m.redundant[0].row] = -1;
  for (const RowShare& share : m.redundant[0].combination) c[share.row] = share.coefficient;
  EXPECT_NEAR(std::abs(c.normalized().dot(m.left_null_space.col(0))), 1, 1e-13);
}

TEST(SeedP45, NullSpaceIsTheAllowableVelocity) {
  const Phi phi(four_bar_equations());
  const Mobility m = mobility(phi, open_closure(phi));
  ASSERT_EQ(m.null_space.cols(), 1);
  const VectorXd along = m.null_space.col(0) / m.null_space(0, 0);
  EXPECT_NEAR(along[1], -0.164837, kSixDigits);
  EXPECT_NEAR(along[2], 0.279919, kSixDigits);
  EXPECT_NEAR(25 * along[1], -4.120914, kSixDigits);
  EXPECT_NEAR(25 * along[2], 6.997985, kSixDigits);
}

Mechanism sphere() {
  return typed(R"toml(
[unknowns]
lengths = ["x", "y", "z"]
[constants]
L = 2
[equations]
sphere = "x^2 + y^2 + z^2 - L^2"
)toml");
}

TEST(SeedP46, ConstraintForceOfASphereIsRadial) {
  const Vector3d q = Vector3d(1, -2, 2) * 2 / 3;
  const Mobility m = mobility(Phi(sphere()), q);
  const VectorXd direction = m.force_directions.col(0).normalized();
  EXPECT_LT((direction + q.normalized()).norm(), 1e-15);
}

TEST(SeedP47, TangentPlaneOfASphere) {
  const Mobility m = mobility(Phi(sphere()), Vector3d(2, 0, 0));
  ASSERT_EQ(m.null_space.cols(), 2);
  const MatrixXd projector = m.null_space * m.null_space.transpose();
  const MatrixXd expected = Vector3d(0, 1, 1).asDiagonal();
  EXPECT_LT((projector - expected).norm(), 1e-15);
}

TEST(SeedP48, RankTwoAndItsNullVector) {
  EXPECT_EQ(numerical_rank(A48()), 2);
  EXPECT_EQ((A48() * Vector3d(-1, -1, 1)).norm(), 0);
  EXPECT_EQ(A48() * Vector3d(-1, -4, 1), Vector3d(0, -12, -12)) << "the slide's vector is none";
}

TEST(SeedP49, AllowableMotionsFromTheSvd) {
  const MatrixXd R = null_space(A48());
  ASSERT_EQ(R.cols(), 1);
  const VectorXd upward = R.col(0) * (R(0, 0) > 0 ? 1 : -1);
  EXPECT_LT((upward - Vector3d(0.577350, 0.577350, -0.577350)).lpNorm<Eigen::Infinity>(),
            kSixDigits);
  const Mechanism redundant = example("redundant-system");
  const Phi phi12(redundant);
  EXPECT_EQ(mobility(phi12, closure_of(phi12, initial_guess(redundant))).null_space.cols(), 1);
  const Phi phi11(example("double-parallel-crank"));
  const Mobility at60 = mobility(phi11, parallel_pose(60 * kDegree));
  EXPECT_EQ(at60.null_space.cols(), 1);
  EXPECT_LT(
      (phi11.without_drivers().jacobian(parallel_pose(60 * kDegree), 0) * at60.null_space).norm(),
      1e-14);
  EXPECT_EQ(mobility(phi11, parallel_pose(0)).null_space.cols(), 2);
}

}  // namespace
}  // namespace moivre
