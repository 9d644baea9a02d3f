// SPDX-License-Identifier: MIT
// Does a branch go where closed forms say, with their velocities and accelerations, and end where
// they say?
#include "moivre/kinematics/branch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../mechanism/files.h"
#include "moivre/kinematics/newton.h"

namespace moivre {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using test::example;
using test::kDegree;
using test::typed;

constexpr double kRounding = 1e-11;     // beside the largest value of its kind
constexpr double kDriverValue = 1e-10;  // radians: how exactly events are located

std::vector<double> even_times(double from, double to, int steps) {
  std::vector<double> times;
  for (int k = 0; k <= steps; ++k) times.push_back(from + (to - from) * k / steps);
  return times;
}

VectorXd assembled(const Mechanism& mechanism, double time) {
  const NewtonResult run = newton(Phi(mechanism), initial_guess(mechanism, time), time);
  EXPECT_EQ(run.status, NewtonStatus::converged) << run.message;
  return run.q;
}

Branch followed(const Mechanism& mechanism, double from, double to, int steps) {
  return follow_branch(mechanism, assembled(mechanism, from), even_times(from, to, steps));
}

/// A four-bar in metres with its crank driven from `start_deg` by 60 deg/s; the guess places
/// coupler and rocker.
Mechanism four_bar(double ground, double crank, double coupler, double rocker, double start_deg,
                   const std::string& guess, const std::string& more = "") {
  const auto text = [](double x) { return std::to_string(x); };
  return typed("[units]\nangle = \"deg\"\n[ground.points]\nO2 = [0, 0]\nO4 = [" + text(ground) +
               ", 0]\n[body.crank.points]\nO2 = [0, 0]\nA = [" + text(crank) +
               ", 0]\n[body.coupler.points]\nA = [0, 0]\nB = [" + text(coupler) +
               ", 0]\n[body.rocker.points]\nO4 = [0, 0]\nB = [" + text(rocker) +
               ", 0]\n"
               "[[joint]]\ntype = \"revolute\"\nat = [\"ground.O2\", \"crank.O2\"]\n"
               "[[joint]]\ntype = \"revolute\"\nat = [\"crank.A\", \"coupler.A\"]\n"
               "[[joint]]\ntype = \"revolute\"\nat = [\"coupler.B\", \"rocker.B\"]\n"
               "[[joint]]\ntype = \"revolute\"\nat = [\"ground.O4\", \"rocker.O4\"]\n" +
               more + "[[driver]]\nangle = \"crank\"\nstart = " + text(start_deg) +
               "\nvelocity = 60\n[guess]\n" + guess);
}

double driver_rad(const Mechanism& mechanism, double time) {
  return driver_state(mechanism.drivers.at(0).law, time).value;
}

// Coordinates of the four-bar's coupler and rocker angles in q.
constexpr Index kCoupler = 5;
constexpr Index kRocker = 8;

/// The Norton four-bar, its crank at 40 degrees with 25 rad/s and 15 rad/s^2 at time `at`.
Mechanism norton(double at) {
  Mechanism m = example("four-bar");
  m.drivers.at(0).law = Parabola{40 * kDegree - 25 * at + 15 * at * at / 2, 25 - 15 * at, 15};
  return m;
}

TEST(Branch, HasVelocitiesWhereTheyAreAskedForAndTheSamePosesElsewhere) {
  const Mechanism m = norton(0.05);
  const Branch all = followed(m, 0, 0.1, 10);
  const std::vector<double> times = even_times(0, 0.1, 10);
  BranchOptions options;
  options.velocity_times = {times[3], times[7]};
  const Branch some = follow_branch(m, assembled(m, 0), times, options);
  ASSERT_EQ(some.samples.size(), all.samples.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    const BranchSample& sample = some.samples[k];
    EXPECT_EQ(sample.q, all.samples[k].q);
    EXPECT_EQ(sample.residual, all.samples[k].residual);
    EXPECT_TRUE(sample.is_determined);
    const bool is_asked_for = k == 3 || k == 7;
    EXPECT_EQ(sample.velocity, is_asked_for ? all.samples[k].velocity : VectorXd());
    EXPECT_EQ(sample.acceleration, is_asked_for ? all.samples[k].acceleration : VectorXd());
  }
}

TEST(Branch, NortonsVelocitiesAndAccelerationsAreMetOnTheWay) {
  constexpr double kThreeDecimals = 5e-4;  // as printed
  const Mechanism m = norton(0.05);
  const Branch branch = followed(m, 0, 0.1, 10);
  ASSERT_EQ(branch.status, BranchStatus::reached) << branch.message;
  const BranchSample& at_40 = branch.samples.at(5);
  EXPECT_NEAR(at_40.q[kCoupler] / kDegree, 20.30, 5e-3);
  EXPECT_NEAR(at_40.q[kRocker] / kDegree, 57.33, 1e-2);  // 57.325, printed rounded up
  EXPECT_NEAR(at_40.velocity[kCoupler], -4.121, kThreeDecimals);
  EXPECT_NEAR(at_40.velocity[kRocker], 6.998, kThreeDecimals);
  EXPECT_NEAR(at_40.acceleration[kCoupler], 296.089, kThreeDecimals);
  EXPECT_NEAR(at_40.acceleration[kRocker], 470.134, kThreeDecimals);
}

TEST(Branch, NortonsFormulasHoldAtEverySampleOfATurn) {
  const double a = 40, b = 120, c = 80;
  const Mechanism m = norton(0);
  const Branch branch = followed(m, 0, 0.2347, 90);
  ASSERT_EQ(branch.samples.size(), 91U) << branch.message;
  for (const BranchSample& sample : branch.samples) {
    const DriverState crank = driver_state(m.drivers[0].law, sample.time);
    const double t2 = crank.value, w2 = crank.velocity, a2 = crank.acceleration;
    const double t3 = sample.q[kCoupler], t4 = sample.q[kRocker];
    EXPECT_NEAR(a * std::cos(t2) + b * std::cos(t3) - c * std::cos(t4), 100, 1e-11);
    EXPECT_NEAR(a * std::sin(t2) + b * std::sin(t3) - c * std::sin(t4), 0, 1e-11);
    const double w3 = a * w2 * std::sin(t4 - t2) / (b * std::sin(t3 - t4));
    const double w4 = a * w2 * std::sin(t2 - t3) / (c * std::sin(t4 - t3));
    EXPECT_NEAR(sample.velocity[kCoupler], w3, kRounding * 25);
    EXPECT_NEAR(sample.velocity[kRocker], w4, kRounding * 25);
    // Two equations A3 a3 + A4 a4 = rhs from the loop, solved by Cramer's rule.
    const double x = a * a2 * std::sin(t2) + a * w2 * w2 * std::cos(t2) +
                     b * w3 * w3 * std::cos(t3) - c * w4 * w4 * std::cos(t4);
    const double y = -a * a2 * std::cos(t2) + a * w2 * w2 * std::sin(t2) +
                     b * w3 * w3 * std::sin(t3) - c * w4 * w4 * std::sin(t4);
    const double a3 = (x * std::cos(t4) + y * std::sin(t4)) / (b * std::sin(t4 - t3));
    const double a4 = (x * std::cos(t3) + y * std::sin(t3)) / (c * std::sin(t4 - t3));
    EXPECT_NEAR(sample.acceleration[kCoupler], a3, kRounding * 1000);
    EXPECT_NEAR(sample.acceleration[kRocker], a4, kRounding * 1000);
  }
}

TEST(Branch, SliderCrankOfExample313StartsWithThePrintedRates) {
  const Mechanism m = example("slider-crank-equations");
  const Branch branch = followed(m, 0, 0.1, 10);
  ASSERT_EQ(branch.status, BranchStatus::reached) << branch.message;
  const BranchSample& first = branch.samples.front();
  EXPECT_NEAR(first.velocity[1], -5, kRounding);
  EXPECT_NEAR(first.velocity[2], -10, kRounding);
  EXPECT_NEAR(first.acceleration[1], -11.547005383792516, 1e-10);
  EXPECT_NEAR(first.acceleration[2], -63.50852961085883, 1e-10);
}

TEST(Branch, ScotchYokeFollowsTheCosine) {
  const Mechanism m = example("scotch-yoke");
  const Branch branch = followed(m, 0, 6, 72);
  ASSERT_EQ(branch.samples.size(), 73U) << branch.message;
  const double w = 60 * kDegree;
  for (const BranchSample& sample : branch.samples) {
    const double phi = driver_rad(m, sample.time);
    EXPECT_NEAR(sample.q[3], 2 * std::cos(phi), kRounding);
    EXPECT_NEAR(sample.velocity[3], -2 * w * std::sin(phi), kRounding);
    EXPECT_NEAR(sample.acceleration[3], -2 * w * w * std::cos(phi), kRounding);
  }
}

TEST(Branch, WhitworthsLeverFollowsItsClosedForm) {
  const Mechanism m = example("whitworth");
  const Branch branch = followed(m, 0, 6, 72);
  ASSERT_EQ(branch.samples.size(), 73U) << branch.message;
  const double a = 1.5, d = 3, w = 60 * kDegree;
  double least = 0, most = 0;
  for (const BranchSample& sample : branch.samples) {
    const double phi = driver_rad(m, sample.time);
    const double square = a * a + d * d + 2 * a * d * std::sin(phi);
    const double rate = w * (a * a + a * d * std::sin(phi)) / square;
    // d/dt of rate.
    const double bend = w * w * a * d * std::cos(phi) * (d * d - a * a) / (square * square);
    EXPECT_NEAR(sample.q[5], std::atan2(d + a * std::sin(phi), a * std::cos(phi)), kRounding);
    EXPECT_NEAR(sample.velocity[5], rate, kRounding);
    EXPECT_NEAR(sample.acceleration[5], bend, kRounding);
    least = std::min(least, rate);
    most = std::max(most, rate);
  }
  // The quick return: the lever goes back three times as fast as forth, (1.5 / 1.5) against (1.5 /
  // 4.5).
  EXPECT_NEAR(-least / most, 3, 1e-2);
}

TEST(Branch, CrankThatCannotTurnRoundEndsWhereTheTriangleCloses) {
  // Dead where coupler and rocker stretch: crank 80, ground 100 and 60 + 50 are a triangle.
  const double limit = std::acos((80.0 * 80 + 100 * 100 - 110 * 110) / (2.0 * 80 * 100));
  const std::string guess = "\"coupler.phi\" = 20\n\"rocker.phi\" = 100\n";
  const Mechanism m = four_bar(100, 80, 60, 50, 45, guess);
  for (const double to : {2.0, -3.0}) {
    const Branch branch = followed(m, 0, to, 20);
    ASSERT_EQ(branch.status, BranchStatus::ended) << branch.message;
    EXPECT_EQ(branch.event->kind, EventKind::dead_point);
    if (to > 0) {
      EXPECT_NEAR(driver_rad(m, branch.event->time), limit, kDriverValue);
      EXPECT_NEAR(
          std::remainder(branch.event->q[kCoupler] - branch.event->q[kRocker], std::numbers::pi), 0,
          1e-8);
    }
    for (const BranchSample& sample : branch.samples) {
      EXPECT_LE(std::abs(sample.time), std::abs(branch.event->time));
      EXPECT_LE(sample.residual, 1e-12);
    }
    ASSERT_TRUE(branch.beyond);
    EXPECT_LE(scaled_residual(Phi(m), branch.beyond->q, branch.beyond->time), 1e-12);
  }
}

TEST(Branch, BothDeadPointsOfTheOffsetSliderCrankAreLocated) {
  // sin(phi1) = (r +- a) / b: 6/10 going up, 2/10 going down.
  const Mechanism m = example("slider-crank-equations");
  const Branch up = followed(m, 0, 1, 40);
  const Branch down = followed(m, 0, -1, 40);
  ASSERT_EQ(up.status, BranchStatus::ended);
  ASSERT_EQ(down.status, BranchStatus::ended);
  EXPECT_NEAR(driver_rad(m, up.event->time), std::asin(0.6), kDriverValue);
  EXPECT_NEAR(driver_rad(m, down.event->time), std::asin(0.2), kDriverValue);
}

TEST(Branch, ParallelogramEndsAtItsChangePointsFromEitherBranchAndSide) {
  for (const bool is_parallel : {true, false}) {
    const std::string guess = is_parallel ? "\"coupler.phi\" = 0\n\"rocker.phi\" = 60\n"
                                          : "\"coupler.phi\" = -38\n\"rocker.phi\" = -98\n";
    const Mechanism m = four_bar(3, 2, 3, 2, 60, guess);
    const Branch on = followed(m, 0, 4, 40);
    const Branch back = followed(m, 0, -4, 40);
    for (const Branch* branch : {&on, &back}) {
      ASSERT_EQ(branch->status, BranchStatus::ended) << branch->message;
      EXPECT_EQ(branch->event->kind, EventKind::bifurcation);
    }
    EXPECT_NEAR(driver_rad(m, on.event->time), std::numbers::pi, kDriverValue);
    EXPECT_NEAR(driver_rad(m, back.event->time), 0, kDriverValue);
  }
}

TEST(Branch, BifurcationExactlyAtTheLastTimeIsReported) {
  const Mechanism m = four_bar(3, 2, 3, 2, 60, "\"coupler.phi\" = 0\n\"rocker.phi\" = 60\n");
  const Branch branch = followed(m, 0, 2, 12);
  ASSERT_EQ(branch.status, BranchStatus::ended) << branch.message;
  EXPECT_NEAR(driver_rad(m, branch.event->time), std::numbers::pi, kDriverValue);
  EXPECT_EQ(branch.samples.size(), 12U);
}

/// The toggle with its elbow up.
Mechanism toggle(const std::string& value) {
  return typed(test::toggle_text(value) + "[guess]\n\"a.phi\" = 1\n\"b.phi\" = -1\n");
}

// The elbow's height is the root of 1 - s^2 / 4: like the time to go, its square, its cube.
TEST(Branch, LocatesWhereBranchesCrossAndWhereTheyTouch) {
  for (const char* value : {"2 - (t - 1)^2", "2 - (t - 1)^4", "2 - 8*(t - 1)^4", "2 - (t - 1)^6"}) {
    for (const double from : {0.3, 0.5, 0.8}) {
      const Mechanism m = toggle(value);
      if (driver_rad(m, from) < 0.1) continue;  // too far in for Newton's method
      const Branch branch = followed(m, from, 2 - from, 10);
      ASSERT_EQ(branch.status, BranchStatus::ended) << value << ": " << branch.message;
      EXPECT_EQ(branch.event->kind, EventKind::bifurcation) << value;
      constexpr double kOften = 10;  // an estimate
      constexpr double kUseful = 2e-6;
      EXPECT_NEAR(branch.event->time, 1, kOften * branch.event->uncertainty) << value;
      EXPECT_LE(branch.event->uncertainty, kUseful) << value;
    }
  }
}

// Beside a crossing points are known to 1e-16 / sigma, which is more than a thousandth of so short
// a step.
TEST(Branch, ComesToACrossingByStepsThatAreAsShortAsWhatIsKnownOfPoints) {
  for (const bool is_parallel : {true, false}) {
    const std::string guess = is_parallel ? "\"coupler.phi\" = 0\n\"rocker.phi\" = 60\n"
                                          : "\"coupler.phi\" = -38\n\"rocker.phi\" = -98\n";
    const Mechanism m = four_bar(3, 2, 3, 2, 60, guess);
    for (const double tighter : {1.0 / 16, 1.0 / 64, 1.0 / 256}) {
      BranchOptions options;
      options.largest_turn_rad *= tighter;
      options.largest_miss *= tighter;
      options.longest_step *= tighter;
      options.largest_approach *= tighter;
      const Branch branch = follow_branch(m, assembled(m, 0), even_times(0, 4, 8), options);
      ASSERT_EQ(branch.status, BranchStatus::ended) << tighter << ": " << branch.message;
      EXPECT_EQ(branch.event->kind, EventKind::bifurcation);
      EXPECT_NEAR(branch.event->time, 2, 10 * branch.event->uncertainty) << tighter;
      EXPECT_LE(branch.event->uncertainty, 1e-6) << tighter;
    }
  }
}

TEST(Branch, DoubleParallelCrankWithItsRedundantRowEndsAtTheLine) {
  const Mechanism m = example("double-parallel-crank");
  const Branch branch = followed(m, 0, 6, 60);
  ASSERT_EQ(branch.status, BranchStatus::ended) << branch.message;
  EXPECT_EQ(branch.event->kind, EventKind::bifurcation);
  EXPECT_NEAR(driver_rad(m, branch.event->time), std::numbers::pi, kDriverValue);
  for (const BranchSample& sample : branch.samples) {
    EXPECT_NEAR(sample.velocity[5], 60 * kDegree, kRounding);  // every crank turns alike
    EXPECT_LE(sample.residual, 1e-12);
  }
}

TEST(Branch, PassesANearChangePointOnItsOwnBranch) {
  // Grashof's links by a hair: at 180 degrees two branches pass each other closely, neither ends.
  // There and back again.
  for (const double more : {1e-2, 1e-4, 1e-6}) {
    const Mechanism m =
        four_bar(3 + more, 2, 3, 2 + 2 * more, 60, "\"coupler.phi\" = 0\n\"rocker.phi\" = 60\n");
    const VectorXd q0 = assembled(m, 0);
    const Branch there = follow_branch(m, q0, even_times(0, 4, 8));
    ASSERT_EQ(there.status, BranchStatus::reached) << more << ": " << there.message;
    const Branch back = follow_branch(m, there.samples.back().q, even_times(4, 0, 16));
    ASSERT_EQ(back.status, BranchStatus::reached) << more << ": " << back.message;
    EXPECT_LE((back.samples.back().q - q0).lpNorm<Eigen::Infinity>(), 1e-8) << more;
  }
}

TEST(Branch, EndsAtAJointsLimit) {
  const Mechanism m = four_bar(100, 40, 120, 80, 40, "\"coupler.phi\" = 20\n\"rocker.phi\" = 57\n",
                               "limits = [0, 70]\nname = \"O4\"\n");
  const Branch branch = followed(m, 0, 2, 20);
  ASSERT_EQ(branch.status, BranchStatus::ended) << branch.message;
  EXPECT_EQ(branch.event->kind, EventKind::joint_limit);
  EXPECT_EQ(branch.event->joint, "O4");
  EXPECT_NEAR(branch.event->q[kRocker], 70 * kDegree, 1e-10);
}

/// Whether central differences of order four of `values` give `rates`, as far as the samples are
/// smooth.
void expect_derivative(const Branch& branch, double h, VectorXd BranchSample::*value,
                       VectorXd BranchSample::*rate, const std::string& name) {
  constexpr double kJump = 1;  // a rotation vector was shortened by a turn
  double size = 1;
  for (const BranchSample& sample : branch.samples) {
    size = std::max(size, (sample.*rate).lpNorm<Eigen::Infinity>());
  }
  for (std::size_t k = 2; k + 2 < branch.samples.size(); ++k) {
    const auto at = [&](std::size_t i) -> const VectorXd& { return branch.samples[i].*value; };
    const auto& q = [&](std::size_t i) -> const VectorXd& { return branch.samples[i].q; };
    if ((q(k + 2) - q(k - 2)).lpNorm<Eigen::Infinity>() > kJump * std::max(1.0, q(k).norm()))
      continue;
    const VectorXd difference = (8 * (at(k + 1) - at(k - 1)) - (at(k + 2) - at(k - 2))) / (12 * h);
    EXPECT_LE((difference - branch.samples[k].*rate).lpNorm<Eigen::Infinity>(), 1e-6 * size)
        << name << " at t = " << branch.samples[k].time;
  }
}

TEST(Branch, VelocityIsTheDerivativeOfPositionAndAccelerationOfVelocity) {
  const char* names[] = {"four-bar",
                         "slider-crank",
                         "five-bar",
                         "watt-1",
                         "stephenson-3",
                         "jansen-leg",
                         "double-parallel-crank",
                         "whitworth",
                         "inverted-slider-crank",
                         "gear-five-bar",
                         "rssr",
                         "bennett"};
  for (const std::string name : names) {
    const Mechanism m = example(name);
    const double to = name == "four-bar" ? 0.02 : name == "slider-crank" ? 0.05 : 0.5;
    const Branch branch = followed(m, 0, to, 100);
    ASSERT_EQ(branch.status, BranchStatus::reached) << name << ": " << branch.message;
    expect_derivative(branch, to / 100, &BranchSample::q, &BranchSample::velocity, name);
    expect_derivative(branch, to / 100, &BranchSample::velocity, &BranchSample::acceleration, name);
  }
}

TEST(Branch, ThereAndBackAgainIsTheSamePose) {
  for (const std::string name : {"watt-1", "jansen-leg", "whitworth", "rssr", "bennett"}) {
    const Mechanism m = example(name);
    const Phi phi(m);
    const VectorXd q0 = assembled(m, 0);
    const Branch there = follow_branch(m, q0, even_times(0, 6, 3));
    ASSERT_EQ(there.status, BranchStatus::reached) << name << ": " << there.message;
    const Branch back = follow_branch(m, there.samples.back().q, even_times(6, 0, 7));
    ASSERT_EQ(back.status, BranchStatus::reached) << name << ": " << back.message;
    const VectorXd gap = phi.canonical(back.samples.back().q) - phi.canonical(q0);
    EXPECT_LE(phi.canonical(gap).lpNorm<Eigen::Infinity>(), 1e-9) << name;
  }
}

TEST(Branch, TurnsAreCountedOn) {
  const Branch branch = followed(example("scotch-yoke"), 0, 60, 10);
  ASSERT_EQ(branch.status, BranchStatus::reached);
  EXPECT_NEAR(branch.samples.back().q[2] - branch.samples.front().q[2], 20 * std::numbers::pi,
              1e-9);
}

TEST(Branch, StepsFollowTheCurveAndNotTheSamples) {
  const Mechanism m = example("jansen-leg");
  const Branch few = followed(m, 0, 6, 2);
  const Branch many = followed(m, 0, 6, 1000);
  ASSERT_EQ(many.samples.size(), 1001U);
  EXPECT_NEAR(few.steps, many.steps, 0.1 * few.steps);
  for (std::size_t k = 0; k < few.samples.size(); ++k) {
    EXPECT_LE((few.samples[k].q - many.samples[500 * k].q).lpNorm<Eigen::Infinity>(), 1e-10);
  }
}

TEST(Branch, FastDriversLawIsNotSteppedOver) {
  Mechanism m = typed(
      "[units]\nangle = \"deg\"\n[ground.points]\nO = [0, 0]\n[body.arm.points]\nO = [0, 0]\n"
      "[[joint]]\ntype = \"revolute\"\nat = [\"ground.O\", \"arm.O\"]\n"
      "[[driver]]\nangle = \"arm\"\nvalue = \"100*sin(100*t)\"\n");
  const Branch branch = followed(m, 0, 1, 200);
  ASSERT_EQ(branch.samples.size(), 201U) << branch.message;
  for (const BranchSample& sample : branch.samples) {
    EXPECT_NEAR(sample.q[2], 100 * kDegree * std::sin(100 * sample.time), 1e-10);
  }
}

TEST(Branch, WithoutDriversAFreeMechanismIsRefusedByItsResult) {
  Mechanism m = example("four-bar");
  m.drivers.clear();
  const Branch branch = followed(m, 0, 1, 2);
  EXPECT_EQ(branch.status, BranchStatus::failed);
  EXPECT_EQ(
      branch.message,
      "fewer constraints than coordinates: the pose moves though the drivers stand; give drivers");
}

TEST(Branch, BeginningAtABifurcationEndsAtOnce) {
  const Mechanism m = example("parallelogram");
  const Branch branch = followed(m, 0, 1, 2);
  ASSERT_EQ(branch.status, BranchStatus::ended);
  EXPECT_EQ(branch.event->kind, EventKind::bifurcation);
  EXPECT_EQ(branch.samples.size(), 1U);
  EXPECT_FALSE(branch.samples.front().is_determined);
}

TEST(Branch, StopsWhenToldAndAtTheLimitOfSteps) {
  const Mechanism m = example("four-bar");
  const VectorXd q0 = assembled(m, 0);
  const std::atomic<bool> stop{true};
  EXPECT_EQ(follow_branch(m, q0, even_times(0, 1, 2), {}, stop).status, BranchStatus::interrupted);
  BranchOptions options;
  options.maximum_steps = 3;
  const Branch branch = follow_branch(m, q0, even_times(0, 1, 2), options);
  EXPECT_EQ(branch.status, BranchStatus::failed);
  EXPECT_EQ(branch.message, "not followed further: the limit of steps was reached");
}

TEST(Branch, WrongCallsAreRefused) {
  const Mechanism m = example("four-bar");
  const VectorXd q0 = assembled(m, 0);
  EXPECT_THROW(follow_branch(m, q0, {0}), std::invalid_argument);
  EXPECT_THROW(follow_branch(m, q0, {0, 1, 1}), std::invalid_argument);
  EXPECT_THROW(follow_branch(m, q0.head(3), {0, 1}), std::invalid_argument);
  EXPECT_THROW(follow_branch(m, VectorXd::Ones(9), {0, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
