// SPDX-License-Identifier: MIT
// Do actuators have the closures of rods of the driven lengths, in the plane and in space, and does
// a free one hold nothing?
#include <gtest/gtest.h>

#include <cmath>

#include "mechanisms.h"
#include "moivre/certify/certifier.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/kinematics/newton.h"
#include "moivre/kinematics/state.h"
#include "moivre/mechanism/driven_joint.h"
#include "moivre/mechanism/pose.h"
#include "moivre/motion/motion.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

/// A boom of 3 on a pin; a cylinder from 4 beside it to its tip.
const std::string kBoom = R"toml(
[ground.points]
O = [0, 0]
B = [4, 0]
[body.boom.points]
O = [0, 0]
T = [3, 0]
[[joint]]
type = "actuator"
at = ["ground.B", "boom.T"]
name = "lift"
)toml";
const std::string kPin = "[[joint]]\ntype = \"revolute\"\nat = [\"ground.O\", \"boom.O\"]\n";

Mechanism boom(const std::string& law) {
  return mechanism_text(kBoom + kPin + "[[driver]]\nslide = \"lift\"\n" + law);
}

/// L^2 = 3^2 + 4^2 - 2 3 4 cos(phi)
double boom_angle(double length) { return std::acos((25 - length * length) / 24); }

TEST(AnActuator, ClosesATriangleInTwoWays) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  for (const double length : {1.5, 3.0, 5.0, 6.9}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Mechanism m = boom("start = " + std::to_string(length));
      const ClosureResult result = closures_of(m, seed);
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(result.counts.complex, 2U);
      ASSERT_EQ(result.closures.size(), 2U);
      EXPECT_NEAR(result.closures[0].q[2], boom_angle(length), 1e-6);
      EXPECT_NEAR(result.closures[1].q[2], -boom_angle(length), 1e-6);
      for (const Closure& closure : result.closures) {
        EXPECT_NEAR(joint_coordinate(m, m.joints[0], closure.q).value(), length, 1e-12);
        EXPECT_TRUE(closure.certified);
      }
    }
  }
}

TEST(AnActuator, OfALengthThatIsBelowZeroOrTooLongCannotBeAssembled) {
  for (const char* length : {"-3", "0.5", "7.5"}) {
    const ClosureResult result = closures_of(boom(std::string("start = ") + length));
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 2U);
    EXPECT_EQ(result.counts.real, 0U) << length;
  }
}

TEST(AnActuator, TurnsTheBoomAtTheSpeedOfItsTriangle) {
  const double L = 3, rate = 0.5, growth = -0.2;
  const Mechanism m = boom("start = 3\nvelocity = 0.5\nacceleration = -0.2");
  const double phi = boom_angle(L);
  const MotionState state = motion_state(Phi(m), closures_of(m).closures.at(0).q, 0);
  // L L' = 12 sin(phi) phi', L'^2 + L L'' = 12 (cos(phi) phi'^2 + sin(phi) phi'')
  const double turning = L * rate / (12 * std::sin(phi));
  EXPECT_NEAR(state.velocity[2], turning, 1e-12);
  EXPECT_NEAR(state.acceleration[2],
              ((rate * rate + L * growth) / 12 - std::cos(phi) * turning * turning) / std::sin(phi),
              1e-12);
  const ScalarState slide =
      joint_state(m, m.joints[0], state.q, state.velocity, state.acceleration).value();
  EXPECT_NEAR(slide.value, L, 1e-12);
  EXPECT_NEAR(slide.velocity, rate, 1e-12);
  EXPECT_NEAR(slide.acceleration, growth, 1e-12);
}

TEST(AnActuator, ComesToADeadPointWhereTheTriangleFoldsOut) {
  const Mechanism m = boom("start = 6\nvelocity = 1");
  MotionOptions options;
  options.to = 2;
  options.solve.threads = 1;
  const MotionResult result = find_motion(m, *make_cvode_tracker(), options);
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.events.size(), 1U);
  EXPECT_NEAR(result.events[0].drivers.at(0), 7, 1e-9);
}

TEST(AnActuatorWithALength, StandsThereAsIfDriven) {
  const std::string at = "name = \"lift\"\n";
  std::string text = kBoom + kPin;
  text.replace(text.find(at), at.size(), at + "length = 5\n");
  const Mechanism m = mechanism_text(text);
  ASSERT_EQ(m.drivers.size(), 1U);
  EXPECT_EQ(driven_joint(m, 0, 0).slide.value(), 5);
  EXPECT_EQ(closures_of(m).counts.real, 2U);
}

TEST(AnActuatorThatIsNotDriven, HoldsNothingButItsLimits) {
  const std::string turned = kPin + "[[driver]]\nangle = \"boom\"\nstart = 1\n";
  const double length = std::sqrt(25 - 24 * std::cos(1.0));
  const auto limited = [&](double upper) {
    std::string text = kBoom;
    return closures_of(
        mechanism_text(text + "limits = [1, " + std::to_string(upper) + "]\n" + turned));
  };
  const Mechanism m = mechanism_text(kBoom + turned);
  EXPECT_EQ(Phi(m).size(), 3);
  const ClosureResult free = closures_of(m);
  ASSERT_EQ(free.closures.size(), 1U);
  EXPECT_NEAR(joint_coordinate(m, m.joints[0], free.closures[0].q).value(), length, 1e-12);
  EXPECT_EQ(limited(length + 0.01).closures.size(), 1U);
  EXPECT_EQ(limited(length - 0.01).counts.filtered, 1U);
}

TEST(AnActuator, PlacesNoBodyThatAPinPlaces) {
  const Mechanism m = boom("start = 3");
  EXPECT_EQ(initial_guess(m).head<2>().norm(), 0);
}

/// The mechanism with every rod an actuator that is driven to its length.
Mechanism with_actuators(Mechanism m) {
  for (std::size_t k = 0; k < m.joints.size(); ++k) {
    Joint& joint = m.joints[k];
    if (joint.type != JointType::rod) continue;
    joint.type = JointType::actuator;
    Driver driver;
    driver.kind = DriverKind::slide;
    driver.name = joint.name;
    driver.joint = k;
    driver.law = Parabola{joint.length, 0.1, 0};
    joint.length = 0;
    m.drivers.push_back(driver);
  }
  return m;
}

TEST(Actuators, HaveTheClosuresOfRodsThatAreAsLong) {
  for (const char* name : {"3-rpr", "rssr", "platform-6-3", "planar-platform"}) {
    const Mechanism rods = mechanism_file(name);
    const Mechanism actuators = with_actuators(rods);
    const ClosureResult of_rods = closures_of(rods);
    const ClosureResult result = closures_of(actuators);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, of_rods.counts.complex) << name;
    EXPECT_EQ(result.paths.tracked, of_rods.paths.tracked) << name;
    ASSERT_EQ(result.closures.size(), of_rods.closures.size()) << name;
    for (std::size_t k = 0; k < result.closures.size(); ++k) {
      EXPECT_LT((result.closures[k].q - of_rods.closures[k].q).norm(), 1e-9) << name;
      EXPECT_LT(scaled_residual(Phi(actuators), result.closures[k].q, 0), 1e-12) << name;
    }
  }
}

TEST(APlatformOnActuators, MovesAsItsLegsAreDriven) {
  const Mechanism m = with_actuators(mechanism_file("planar-platform"));
  const Phi phi(m);
  const VectorXd q = closures_of(m).closures.at(0).q;
  EXPECT_EQ(mobility(phi, q).degrees_of_freedom, 6);
  EXPECT_EQ(mobility(phi, q).driven_freedoms, 0);
  const MotionState state = motion_state(phi, q, 0);
  constexpr double kStep = 1e-4;
  const NewtonResult later = newton(phi, q + kStep * state.velocity, kStep);
  const NewtonResult before = newton(phi, q - kStep * state.velocity, -kStep);
  EXPECT_LT(((later.q - before.q) / (2 * kStep) - state.velocity).norm(),
            1e-6 * (1 + state.velocity.norm()));
}

}  // namespace
}  // namespace moivre
