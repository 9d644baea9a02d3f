// SPDX-License-Identifier: MIT
// Do racks and pinions stand where rolling puts them, whichever end is known, and is a rack that no
// polynomial settles refused?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanisms.h"
#include "moivre/certify/certifier.h"
#include "moivre/kinematics/state.h"
#include "moivre/mechanism/pose.h"
#include "moivre/motion/motion.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

constexpr double kRackDegree = std::numbers::pi / 180;
constexpr double kPlace = 1e-9;  // lengths being about 100

std::string pinned(const std::string& a, const std::string& b) {
  return "[[joint]]\ntype = \"revolute\"\nat = [\"" + a + "\", \"" + b + "\"]\n";
}

std::string driven(const std::string& what, const std::string& start) {
  return "[[driver]]\n" + what + "\nstart = " + start + "\nvelocity = 1\n";
}

/// A bar that slides along the ground, at a slope of 3 to 4, on a pinion of radius 20 on its right.
const std::string kSlopingRack = R"toml(
[units]
angle = "deg"
[ground.points]
O = [12, -16]
G = [0, 0]
[body.bar.points]
P = [0, 0]
[body.pinion.points]
C = [0, 0]
M = [5, 0]
[[joint]]
type = "prismatic"
at = ["ground.G", "bar.P"]
along = [4, 3]
turn = 36.86989764584402
name = "guide"
[[joint]]
type = "rack"
at = ["bar.P", "pinion.C"]
along = [1, 0]
radius = 20
phase = 10
name = "mesh"
)toml" + pinned("ground.O", "pinion.C");

/// Where the guide has slid by s, the pinion's centre is at -s along the bar.
double pinion_angle(double slide) { return (10 + 36.86989764584402) * kRackDegree - slide / 20; }

double modulo_turn(double a, double b) { return std::remainder(a - b, 2 * std::numbers::pi); }

TEST(ARack, IsShiftedByItsPinionWholeTurnsCounted) {
  for (const double angle : {-800.0, 0.0, 75.0, 1000.0}) {
    const Mechanism m =
        mechanism_text(kSlopingRack + driven("angle = \"pinion\"", std::to_string(angle)));
    const ClosureResult result = closures_of(m);
    ASSERT_EQ(result.closures.size(), 1U) << result.message;
    EXPECT_EQ(result.counts.complex, 1U);
    const VectorXd& q = result.closures[0].q;
    const double slide = joint_coordinate(m, m.joints[0], q).value();
    EXPECT_NEAR(slide, -20 * (angle * kRackDegree - pinion_angle(0)), kPlace);
  }
}

TEST(APinion, IsTurnedByItsRackHoweverThatIsDriven) {
  const double slide = 33;
  const std::string x = std::to_string(slide * 0.8);
  for (const std::string& driver : {driven("slide = \"guide\"", "33"), driven("x = \"bar.P\"", x),
                                    driven("slide = \"mesh\"", "-33")}) {
    const Mechanism m = mechanism_text(kSlopingRack + driver);
    const ClosureResult result = closures_of(m);
    ASSERT_EQ(result.closures.size(), 1U) << result.message;
    EXPECT_TRUE(result.complete);
    const VectorXd& q = result.closures[0].q;
    EXPECT_NEAR(joint_coordinate(m, m.joints[0], q).value(), slide, kPlace);
    EXPECT_NEAR(modulo_turn(q[5], pinion_angle(slide)), 0, kPlace);
    EXPECT_LT(scaled_residual(Phi(m), q, 0), 1e-14);
  }
}

TEST(ARack, MovesAtTheSpeedOfThePitchCircle) {
  const Mechanism m = mechanism_text(kSlopingRack +
                                     "[[driver]]\nangle = \"pinion\"\nstart = 40\n"
                                     "velocity = 90\nacceleration = -30\n");
  const ClosureResult result = closures_of(m);
  ASSERT_EQ(result.closures.size(), 1U);
  const MotionState state = motion_state(Phi(m), result.closures[0].q, 0);
  EXPECT_NEAR(state.velocity[0], -20 * 90 * kRackDegree * 0.8, kPlace);
  EXPECT_NEAR(state.velocity[1], -20 * 90 * kRackDegree * 0.6, kPlace);
  EXPECT_NEAR(state.acceleration[0], 20 * 30 * kRackDegree * 0.8, kPlace);
}

TEST(ARackOnTheGround, RollsItsWheelAlongACycloid) {
  const Mechanism m = mechanism_text(R"toml(
[ground.points]
G = [0, 0]
[body.axle.points]
C = [0, 2]
P = [0, 0]
[body.wheel.points]
C = [0, 0]
M = [0, -2]
[[joint]]
type = "prismatic"
at = ["ground.G", "axle.P"]
along = [1, 0]
[[joint]]
type = "rack"
at = ["ground.G", "wheel.C"]
along = [1, 0]
radius = -2
)toml" + pinned("axle.C", "wheel.C") +
                                     driven("x = \"axle.C\"", "3.5"));
  EXPECT_TRUE(m.warnings.empty());
  const ClosureResult result = closures_of(m);
  ASSERT_EQ(result.closures.size(), 1U) << result.message;
  const Eigen::Vector3d mark = point_position(m, {2, 1}, result.closures[0].q);
  const double turn = 3.5 / 2;
  EXPECT_NEAR(mark.x(), 2 * (turn - std::sin(turn)), kPlace);
  EXPECT_NEAR(mark.y(), 2 * (1 - std::cos(turn)), kPlace);
}

TEST(TwoRacks, OnEitherSideOfAPinionMoveAgainstEachOther) {
  const std::string text = kSlopingRack + R"toml(
[body.other.points]
Q = [0, 0]
[[joint]]
type = "prismatic"
at = ["ground.O", "other.Q"]
along = [4, 3]
turn = 36.86989764584402
name = "other guide"
[[joint]]
type = "rack"
at = ["other.Q", "pinion.C"]
along = [1, 0]
radius = -20
phase = 10
)toml" + driven("slide = \"guide\"", "17");
  const Mechanism m = mechanism_text(text);
  const ClosureResult result = closures_of(m);
  ASSERT_EQ(result.closures.size(), 1U) << result.message;
  EXPECT_NEAR(joint_coordinate(m, m.joints[3], result.closures[0].q).value(), -17, kPlace);
}

/// A crank of 30 and a rod of 90 shift a bar to x; the pinion below it has rolled 80 - x.
TEST(APinionThatFollows, StandsByItsRackInEveryClosureAndForEverySeed) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  for (const double crank : {10.0, 50.0, 200.0}) {
    const Mechanism m = driven_from(mechanism_file("rack-crank"), crank * kRackDegree);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const ClosureResult result = closures_of(m, seed);
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(result.counts.complex, 2U);
      ASSERT_EQ(result.closures.size(), 2U);
      const double foot = 30 * std::cos(crank * kRackDegree);
      const double reach = std::sqrt(90 * 90 - std::pow(30 * std::sin(crank * kRackDegree), 2));
      EXPECT_LT((result.closures[0].q[6] - foot) * (result.closures[1].q[6] - foot), 0);
      for (const Closure& closure : result.closures) {
        const VectorXd& q = closure.q;
        const double x = q[6] > foot ? foot + reach : foot - reach;
        EXPECT_NEAR(q[6], x, kPlace);
        EXPECT_NEAR(modulo_turn(q[11], 90 * kRackDegree + (80 - x) / 10), 0, kPlace);
        EXPECT_TRUE(closure.certified);
      }
    }
  }
}

TEST(APinionThatFollows, IsReadWhereItsCentreIsNotItsOrigin) {
  std::string text = kSlopingRack + driven("slide = \"guide\"", "33");
  const Mechanism plain = mechanism_text(text);
  const std::string centred = "C = [0, 0]\nM = [5, 0]";
  text.replace(text.find(centred), centred.size(), "C = [7, 4]\nM = [12, 4]");
  // A crank in place of the driver, so that the slide is known from a root alone.
  text.replace(text.find("[[driver]]"), std::string::npos, R"toml(
[body.rod.points]
P = [0, 0]
F = [0, 40]
[[joint]]
type = "rod"
at = ["ground.O", "rod.F"]
length = 70
)toml" + pinned("bar.P", "rod.P") + driven("angle = \"rod\"", "20"));
  const Mechanism m = mechanism_text(text);
  const ClosureResult result = closures_of(m);
  ASSERT_EQ(result.counts.complex, 2U) << result.message;
  ASSERT_EQ(result.closures.size(), 2U);
  for (const Closure& closure : result.closures) {
    EXPECT_LE(closure.newton_iterations, 1);
    EXPECT_LT(scaled_residual(Phi(m), closure.q, 0), 1e-13);
    const double slide = joint_coordinate(m, m.joints[0], closure.q).value();
    EXPECT_NEAR(modulo_turn(closure.q[5], pinion_angle(slide)), 0, kPlace);
  }
}

/// An arm that a four-bar turns carries guide, pinion and a wheel that meshes with it; the slide on
/// it is driven.
TEST(ARackOnAMovingArm, TurnsThePinionRelativeToTheArm) {
  const Mechanism m = mechanism_text(
      R"toml(
[ground.points]
O = [0, 0]
D = [9, 0]
[body.arm.points]
O = [0, 0]
B = [6, 0]
G = [2, 1]
C = [3, 0]
W = [6, 0]
[body.coupler.points]
B = [0, 0]
E = [8, 0]
[body.rocker.points]
D = [0, 0]
E = [5, 0]
[body.bar.points]
P = [0, 0]
[body.pinion.points]
C = [0, 0]
[body.wheel.points]
W = [0, 0]
[[joint]]
type = "gear"
bodies = ["pinion", "wheel"]
ratio = [-10, 20]
carrier = "arm"
[[joint]]
type = "prismatic"
at = ["arm.G", "bar.P"]
along = [1, 0]
name = "guide"
[[joint]]
type = "rack"
at = ["bar.P", "pinion.C"]
along = [1, 0]
radius = 1
)toml" +
      pinned("ground.O", "arm.O") + pinned("arm.B", "coupler.B") + pinned("coupler.E", "rocker.E") +
      pinned("ground.D", "rocker.D") + pinned("arm.C", "pinion.C") + pinned("arm.W", "wheel.W") +
      driven("angle = \"rocker\"", "1.9") + driven("slide = \"guide\"", "0.4"));
  const ClosureResult result = closures_of(m);
  EXPECT_EQ(result.counts.complex, 2U) << result.message;
  ASSERT_EQ(result.closures.size(), 2U);
  for (const Closure& closure : result.closures) {
    // The centre is 1 along the arm from where the guide begins.
    EXPECT_NEAR(modulo_turn(closure.q[14], closure.q[2] + 1 - 0.4), 0, kPlace);
    EXPECT_NEAR(modulo_turn(closure.q[17], closure.q[2] - (1 - 0.4) / 2), 0, kPlace);
  }
}

TEST(ARackWithBothEndsDriven, ClosesWhereTheyAgree) {
  const std::string shifted = kSlopingRack + driven("slide = \"guide\"", "33");
  const auto closures_at = [&](const std::string& angle_deg) {
    return closures_of(mechanism_text(shifted + "[[driver]]\nangle = \"pinion\"\nvalue = \"" +
                                      angle_deg + "\""))
        .counts.complex;
  };
  EXPECT_EQ(closures_at("10 + 36.86989764584402 - 33/20*180/pi"), 1U);
  EXPECT_EQ(closures_at("5"), 0U);
}

TEST(ARackInALoopWithItsPinion, IsRefusedWithWhatWorks) {
  const Mechanism m =
      mechanism_text(kSlopingRack + R"toml(
[body.rod.points]
M = [0, 0]
P = [30, 0]
)toml" + pinned("pinion.M", "rod.M") +
                     "[[joint]]\ntype = \"slot\"\nat = [\"bar.P\", \"rod.P\"]\nalong = [0, 1]\n");
  try {
    closures_of(m);
    FAIL() << "a rack in a loop was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "the rack 'mesh' ties an angle to a length, which no polynomial says, and neither is "
              "known before the other; drive the pinion or the rack (slide = \"mesh\"), or follow "
              "one pose with `follow_guesses`");
  }
}

TEST(ARackInMotion, AgreesWithItsCheckpointsBeyondWholeTurns) {
  const auto expect_agreement = [](const Mechanism& mechanism, double duration) {
    MotionOptions options;
    options.to = duration;
    options.steps = 40;
    options.solve.threads = 1;
    const MotionResult result = find_motion(mechanism, *make_cvode_tracker(), options);
    EXPECT_TRUE(result.complete) << result.message;
    for (const Checkpoint& checkpoint : result.checkpoints) {
      EXPECT_TRUE(checkpoint.agrees) << checkpoint.message;
    }
  };
  expect_agreement(mechanism_file("rack-crank"), 2);
  expect_agreement(
      mechanism_text(kSlopingRack + "[[driver]]\nangle = \"pinion\"\nvelocity = 360\n"), 2.5);
}

}  // namespace
}  // namespace moivre
