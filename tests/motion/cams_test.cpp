// SPDX-License-Identifier: MIT
// Do cams lift their followers by the table, whole turns and carriers counted, and is a cam that
// nothing drives refused?
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mechanisms.h"
#include "moivre/kinematics/state.h"
#include "moivre/mechanism/pose.h"
#include "moivre/motion/motion.h"

namespace moivre {
namespace {

constexpr double kCamDegree = std::numbers::pi / 180;

/// An eccentric disc as a table: every degree, or every so many.
std::string eccentric(double middle, double throw_out, int step_deg) {
  std::string rows;
  for (int angle = 0; angle <= 360; angle += step_deg) {
    char row[64];
    std::snprintf(row, sizeof row, "[%d, %.17g], ", angle,
                  middle - throw_out * std::cos(angle % 360 * kCamDegree));
    rows += row;
  }
  return "profile = [" + rows + "]\n";
}

/// A cam on an arm that turns by 30 degrees; the arm guides a tappet at a slope of 3 to 4.
Mechanism tappet(const std::string& profile, const std::string& law) {
  return mechanism_text(R"toml(
[units]
angle = "deg"
[ground.points]
O = [0, 0]
[body.arm.points]
O = [0, 0]
C = [10, 0]
G = [12, -1]
[body.cam.points]
C = [0, 0]
[body.tappet.points]
P = [0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "arm.O"]
[[joint]]
type = "revolute"
at = ["arm.C", "cam.C"]
[[joint]]
type = "prismatic"
at = ["arm.G", "tappet.P"]
along = [4, 3]
name = "guide"
[[joint]]
type = "cam"
at = ["cam.C", "tappet.P"]
along = [4, 3]
carrier = "arm"
phase = 15
name = "lobe"
)toml" + profile + "[[driver]]\nangle = \"arm\"\nstart = 30\n[[driver]]\nangle = \"cam\"\n" +
                        law);
}

TEST(ACam, LiftsByItsTableAsSeenFromTheCarrier) {
  for (const int turned : {0, 60, 170, 350, 740, -30}) {
    const std::string start = "start = " + std::to_string(turned + 30 + 15) + "\n";
    const Mechanism m = tappet(eccentric(5, 2, 10), start);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const ClosureResult result = closures_of(m, seed);
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(result.counts.complex, 1U);
      ASSERT_EQ(result.closures.size(), 1U);
      const double lift = 5 - 2 * std::cos(turned * kCamDegree);
      const Eigen::VectorXd& q = result.closures[0].q;
      EXPECT_NEAR(joint_coordinate(m, m.joints[3], q).value(), lift, 1e-12);
      // The guide begins at (2, -1) from the centre: 1.6 - 0.6 along the line.
      EXPECT_NEAR(joint_coordinate(m, m.joints[2], q).value(), lift - 1, 1e-12);
      EXPECT_LT(scaled_residual(Phi(m), q, 0), 1e-14);
    }
  }
}

TEST(ACam, MovesItsFollowerAsItsProfileSays) {
  const Mechanism m = tappet(eccentric(5, 2, 1), "start = 115\nvelocity = 90\nacceleration = 40\n");
  const MotionState state = motion_state(Phi(m), closures_of(m).closures.at(0).q, 0);
  const ScalarState lift =
      joint_state(m, m.joints[3], state.q, state.velocity, state.acceleration).value();
  const double turned = 70 * kCamDegree, speed = 90 * kCamDegree, growth = 40 * kCamDegree;
  constexpr double kSpline = 1e-3;  // of a table every degree, in the second derivative
  EXPECT_NEAR(lift.velocity, 2 * std::sin(turned) * speed, kSpline * kSpline);
  EXPECT_NEAR(lift.acceleration, 2 * (std::cos(turned) * speed * speed + std::sin(turned) * growth),
              kSpline);
}

TEST(ACamLever, TurnsByTheTableRelativeToTheCarrier) {
  const std::string text = R"toml(
[units]
angle = "deg"
[ground.points]
O = [0, 0]
[body.arm.points]
O = [0, 0]
C = [10, 0]
L = [10, 8]
[body.cam.points]
C = [0, 0]
[body.lever.points]
L = [0, 0]
R = [-3, -4]
[[joint]]
type = "revolute"
at = ["ground.O", "arm.O"]
[[joint]]
type = "revolute"
at = ["arm.C", "cam.C"]
[[joint]]
type = "revolute"
at = ["arm.L", "lever.L"]
[[joint]]
type = "cam-lever"
bodies = ["cam", "lever"]
carrier = "arm"
)toml" + eccentric(10, 6, 10) +
                           "[[driver]]\nangle = \"arm\"\nstart = 30\n";
  const Mechanism m = mechanism_text(text + "[[driver]]\nangle = \"cam\"\nstart = 450\n");
  const ClosureResult result = closures_of(m);
  ASSERT_EQ(result.closures.size(), 1U) << result.message;
  const double lift = 10 - 6 * std::cos(60 * kCamDegree);
  EXPECT_NEAR(result.closures[0].q[8], (30 + lift) * kCamDegree, 1e-12);
  const std::string both = text + "[[driver]]\nangle = \"cam\"\nstart = 450\n";
  const auto with_lever_at = [&](const std::string& angle) {
    return closures_of(mechanism_text(both + "[[driver]]\nangle = \"lever\"\nstart = " + angle))
        .counts.complex;
  };
  EXPECT_EQ(with_lever_at("37"), 1U);
  EXPECT_EQ(with_lever_at("40"), 0U);
  EXPECT_THROW(closures_of(mechanism_text(text + "[[driver]]\nangle = \"lever\"\nstart = 40\n")),
               std::invalid_argument);
}

TEST(ACamAndItsFollower, DrivenBothCloseWhereTheyAgree) {
  const auto closures_at = [](const std::string& lift) {
    return closures_of(tappet(eccentric(5, 2, 10),
                              "start = 105\n[[driver]]\nslide = \"lobe\"\nstart = " + lift + "\n"))
        .counts.complex;
  };
  EXPECT_EQ(closures_at("4"), 1U);  // 60 degrees from where the profile begins
  EXPECT_EQ(closures_at("4.5"), 0U);
}

TEST(ACam, ThatNothingDrivesIsRefusedWithWhatWorks) {
  Mechanism m = tappet(eccentric(5, 2, 10), "start = 0\n");
  m.drivers.back().kind = DriverKind::slide;
  m.drivers.back().joint = 2;
  try {
    closures_of(m);
    FAIL() << "a cam whose follower is driven was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "the cam 'lobe' lifts by a table, which no polynomial says; drive the cam's angle, "
              "or follow one pose with `follow_guesses`");
  }
}

/// A piston turns the crank that carries the cams: their angles come out of the loop, and a tappet
/// and a lever hang on them.
TEST(FollowersOfACam, StandByItsAngleInEveryClosureAndForEverySeed) {
  const std::string text = R"toml(
[units]
angle = "deg"
[ground.points]
O = [0, 0]
G = [1, 0]
L = [-20, 6]
[body.crank.points]
O = [0, 0]
A = [3, 0]
[body.rod.points]
A = [0, 0]
B = [8, 0]
[body.piston.points]
B = [0, 0]
[body.tappet.points]
P = [0.5, 0.25]
[body.lever.points]
L = [2, 1]
R = [9, 1]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "revolute"
at = ["crank.A", "rod.A"]
[[joint]]
type = "revolute"
at = ["rod.B", "piston.B"]
[[joint]]
type = "prismatic"
at = ["ground.O", "piston.B"]
along = [1, 0]
name = "bore"
[[joint]]
type = "prismatic"
at = ["ground.G", "tappet.P"]
along = [0, -1]
turn = 25
[[joint]]
type = "cam"
at = ["crank.O", "tappet.P"]
along = [0, 1]
phase = 15
name = "lobe"
)toml" + eccentric(5, 2, 10) +
                           R"toml([[joint]]
type = "revolute"
at = ["ground.L", "lever.L"]
[[joint]]
type = "cam-lever"
bodies = ["crank", "lever"]
)toml" + eccentric(10, 6, 10) +
                           "[[driver]]\nslide = \"bore\"\nstart = 9.5\nvelocity = 2\n";
  const Mechanism m = mechanism_text(text);
  const Spline lobe = m.joints[5].profile;
  const Spline swing = m.joints[7].profile;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(m, seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 2U);
    ASSERT_EQ(result.closures.size(), 2U);
    for (const Closure& closure : result.closures) {
      const double crank = closure.q[2];
      EXPECT_LE(closure.newton_iterations, 1);
      EXPECT_LT(scaled_residual(Phi(m), closure.q, 0), 1e-13);
      EXPECT_NEAR(point_position(m, {4, 0}, closure.q).y(),
                  periodic_state(lobe, crank - 15 * kCamDegree).value, 1e-12);
      EXPECT_NEAR(closure.q[14], periodic_state(swing, crank).value, 1e-12);
    }
  }
}

TEST(ACamInMotion, AgreesWithItsCheckpointsBeyondAWholeTurn) {
  const Mechanism m = mechanism_file("cam-valve");
  MotionOptions options;
  options.to = 1.7;
  options.solve.threads = 1;
  const MotionResult result = find_motion(m, *make_cvode_tracker(), options);
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.branches.size(), 2U);
  for (const Checkpoint& checkpoint : result.checkpoints) {
    EXPECT_TRUE(checkpoint.agrees) << checkpoint.message;
  }
}

}  // namespace
}  // namespace moivre
