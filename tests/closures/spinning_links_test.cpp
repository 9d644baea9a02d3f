// SPDX-License-Identifier: MIT
// Do links that spin between balls hide no closure, whether they are bodies or lines?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mechanisms.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

TEST(SpinningLinks, ALinkThatSpinsBetweenBallsHidesNoClosure) {
  const Mechanism mechanism = mechanism_text(test::kSpinningCoupler);
  const ClosureResult result = closures_of(mechanism);
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 2U);
  ASSERT_EQ(result.closures.size(), 2U);
  ASSERT_EQ(result.idle.size(), 1U);
  EXPECT_EQ(result.idle[0].body, "coupler");
  EXPECT_EQ(result.mobility->degrees_of_freedom, 2);  // the crank, and the spin
  const double degree = std::numbers::pi / 180;
  const auto output = [&](std::size_t k) {
    return *joint_coordinate(mechanism, mechanism.joints[1], result.closures[k].q) / degree;
  };
  EXPECT_NEAR(std::min(output(0), output(1)), -93.54158024029208, 1e-9);
  EXPECT_NEAR(std::max(output(0), output(1)), 91.57541939668447, 1e-9);
}

/// A MacPherson strut: the wheel's knuckle on a driven arm and a tie rod, and a line of it through
/// the top mount.
std::string macpherson(const std::string& strut) {
  return R"toml(space = "spatial"
[units]
length = "mm"
[ground.points]
LF = [130, 350, 200]
TOP = [-15, 560, 800]
I = [-120, 340, 235]
[body.lower.points]
LF = [130, 350, 200]
LB = [0, 690, 180]
[body.knuckle.points]
LB = [0, 690, 180]
S = [-5, 600, 500]
T = [-130, 670, 240]
[[joint]]
type = "revolute"
at = ["ground.LF", "lower.LF"]
axis = [280, 0, -5]
name = "bush"
[[joint]]
type = "spherical"
at = ["lower.LB", "knuckle.LB"]
[[joint]]
type = "rod"
at = ["knuckle.T", "ground.I"]
length = 330.189339616
[[driver]]
angle = "bush"
start = 0.05
)toml" + strut;
}

// The knuckle turns about two balls, of which the upper one is at either of two places on its line;
// the tie rod leaves two poses of each.
TEST(SpinningLinks, AStrutHasTheSameWhetherItsRodIsABodyThatSpinsOrALine) {
  const std::string line = R"toml([[joint]]
type = "point-on-line"
at = ["knuckle.S", "ground.TOP"]
axis = [-10, -40, 300]
)toml";
  const std::string rod = R"toml([body.strut.points]
S = [-5, 600, 500]
TOP = [-15, 560, 800]
[[joint]]
type = "spherical"
at = ["strut.TOP", "ground.TOP"]
[[joint]]
type = "cylindrical"
at = ["strut.S", "knuckle.S"]
axis = [-10, -40, 300]
name = "damper"
)toml";
  const ClosureResult by_line = closures_of(mechanism_text(macpherson(line)));
  EXPECT_TRUE(by_line.complete) << by_line.message;
  EXPECT_EQ(by_line.counts.complex, 4U) << "none with a quaternion of norm 0 is a pose";
  const ClosureResult by_rod = closures_of(mechanism_text(macpherson(rod)));
  EXPECT_TRUE(by_rod.complete) << by_rod.message;
  ASSERT_EQ(by_rod.idle.size(), 1U);
  EXPECT_EQ(by_rod.idle[0].joint, "damper");
  EXPECT_EQ(by_rod.idle[0].body, "strut");
  EXPECT_EQ(by_rod.counts.complex, 4U);
  ASSERT_EQ(by_rod.closures.size(), by_line.closures.size());
  constexpr Eigen::Index kKnuckle = 6;
  for (const Closure& closure : by_rod.closures) {
    EXPECT_TRUE(std::any_of(by_line.closures.begin(), by_line.closures.end(), [&](const auto& c) {
      return (c.q.segment(kKnuckle, 6) - closure.q.segment(kKnuckle, 6)).norm() < 1e-6;
    }));
  }
}

// A knuckle whose tie rod is a body: that is one distance, and the knuckle is no three distances
// then.
TEST(SpinningLinks, ALinkOfThreeBallsWithARodOnOneOfThemHasItsClosures) {
  const std::string text = R"toml(space = "spatial"
[ground.points]
O = [0, 0, 0]
Q = [200, 50, 0]
S = [80, 200, 60]
[body.crank.points]
O = [0, 0, 0]
A = [0, 0, 60]
[body.link.points]
A = [0, 0, 60]
B = [200, 190, 0]
C = [100, 120, 90]
[body.rocker.points]
Q = [200, 50, 0]
B = [200, 190, 0]
)toml";
  const std::string joints = R"toml([[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
axis = [1, 0, 0]
name = "in"
[[joint]]
type = "spherical"
at = ["crank.A", "link.A"]
[[joint]]
type = "spherical"
at = ["link.B", "rocker.B"]
[[joint]]
type = "revolute"
at = ["ground.Q", "rocker.Q"]
axis = [0, 0, 1]
[[driver]]
angle = "in"
start = 0
)toml";
  const std::string rod = "[[joint]]\ntype = \"rod\"\nat = [\"ground.S\", \"link.C\"]\nlength = " +
                          std::to_string(std::sqrt(400.0 + 6400 + 900)) + "\n";
  const std::string body = R"toml([body.tie.points]
C = [100, 120, 90]
S = [80, 200, 60]
[[joint]]
type = "spherical"
at = ["link.C", "tie.C"]
[[joint]]
type = "spherical"
at = ["tie.S", "ground.S"]
)toml";
  const ClosureResult by_rod = closures_of(mechanism_text(text + joints + rod));
  const ClosureResult by_body = closures_of(mechanism_text(text + body + joints));
  EXPECT_TRUE(by_body.complete) << by_body.message;
  EXPECT_EQ(by_body.counts.real, 2U);
  EXPECT_EQ(by_body.counts.real, by_rod.counts.real);
  EXPECT_EQ(by_body.counts.complex, by_rod.counts.complex);
}

}  // namespace
}  // namespace moivre
