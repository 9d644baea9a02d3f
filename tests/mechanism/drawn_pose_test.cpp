// SPDX-License-Identifier: MIT
// Is a drawing known as one, is its pose the guess, and is a point that one body has elsewhere
// told?
#include "moivre/mechanism/drawn_pose.h"

#include <gtest/gtest.h>

#include "files.h"

namespace moivre::test {
namespace {

/// A four-bar typed from a drawing: crank from O to A, coupler to B, rocker to P; the coupler has
/// `B` where it is asked to.
std::string drawn_four_bar(const std::string& coupler_b = "[110, 70]",
                           const std::string& start = "0") {
  return R"toml([units]
length = "mm"
angle = "deg"
[ground.points]
O = [10, 0]
P = [120, 5]
[body.crank.points]
O = [10, 0]
A = [25, 40]
[body.coupler.points]
A = [25, 40]
B = )toml" +
         coupler_b + R"toml(
[body.rocker.points]
P = [120, 5]
B = [110, 70]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "revolute"
at = ["crank.A", "coupler.A"]
[[joint]]
type = "revolute"
at = ["coupler.B", "rocker.B"]
[[joint]]
type = "revolute"
at = ["rocker.P", "ground.P"]
[[driver]]
angle = "crank"
start = )toml" +
         start + "\n";
}

/// A block on two rails that cross, drawn away from where the first points of its slots are.
std::string drawn_scissor(const std::string& start) {
  return R"toml([units]
length = "mm"
[ground.points]
A = [0, 0]
K = [600, 0]
[body.p.points]
L = [0, 0]
M = [480, 150]
R = [960, 300]
[body.q.points]
R = [960, 0]
M = [480, 150]
L = [0, 300]
C = [240, 225]
[[joint]]
type = "revolute"
at = ["p.M", "q.M"]
[[joint]]
type = "slot"
at = ["ground.A", "q.R"]
along = [1, 0]
[[joint]]
type = "revolute"
at = ["ground.A", "p.L"]
[[joint]]
type = "actuator"
at = ["ground.K", "q.C"]
name = "cyl"
[[driver]]
slide = "cyl"
start = )toml" +
         start + "\n";
}

TEST(DrawnPose, IsTheGuessOfADrawingWhereItsDriversHaveIt) {
  const Mechanism m = typed(drawn_scissor("424.5"));
  EXPECT_TRUE(is_drawn(m));
  EXPECT_TRUE(is_drawn_at(m, 0));
  EXPECT_EQ(initial_guess(m), Eigen::VectorXd(Eigen::VectorXd::Zero(6)));
}

TEST(DrawnPose, GivesTheSlidesOfAGuessThatItsDriversDoNotHave) {
  const Mechanism m = typed(drawn_scissor("300"));
  EXPECT_TRUE(is_drawn(m));
  EXPECT_FALSE(is_drawn_at(m, 0));
  // Not with the slot's second point on its first.
  EXPECT_EQ(initial_guess(m), Eigen::VectorXd(Eigen::VectorXd::Zero(6)));
  EXPECT_EQ(drawn_miss(m, 0).substr(0, 10), "driver cyl");
}

TEST(DrawnPose, IsNoneWhereBodiesHaveFramesOfTheirOwn) {
  for (const char* name : {"four-bar", "stephenson-3", "rssr", "crane"}) {
    EXPECT_FALSE(is_drawn(example(name))) << name;
    for (const std::string& warning : example(name).warnings) {
      EXPECT_EQ(warning.find("mistyped"), std::string::npos) << name << ": " << warning;
    }
  }
}

TEST(DrawnPose, OfAnotherDriverValueLeavesDrivenAnglesToTheirDrivers) {
  const Mechanism m = typed(drawn_four_bar("[110, 70]", "30"));
  EXPECT_TRUE(is_drawn(m));
  EXPECT_FALSE(is_drawn_at(m, 0));
  EXPECT_NEAR(initial_guess(m)[2], 30 * 3.14159265358979 / 180, 1e-12);
}

TEST(MistypedPoint, IsToldWithPointBodiesAndDistance) {
  const Mechanism m = typed(drawn_four_bar("[11, 70]"));
  ASSERT_EQ(m.warnings.size(), 1U);
  for (const char* part : {"coupler.B = [11, 70]", "rocker.B = [110, 70]", "99 mm", "mistyped"}) {
    EXPECT_NE(m.warnings[0].find(part), std::string::npos) << m.warnings[0];
  }
  EXPECT_TRUE(typed(drawn_four_bar()).warnings.empty());
}

TEST(MistypedPoint, IsTheOneThatIsAloneAmongSeveralBodies) {
  std::string text = drawn_four_bar("[110, 75]");
  text.insert(text.find("[[joint]]"), "[body.link.points]\nB = [110, 70]\nE = [150, 80]\n");
  text.insert(text.find("[[driver]]"),
              "[[joint]]\ntype = \"revolute\"\nat = [\"link.B\", \"rocker.B\"]\n");
  const Mechanism m = typed(text);
  ASSERT_FALSE(m.warnings.empty());
  EXPECT_NE(m.warnings.back().find("is 'coupler' mistyped?"), std::string::npos)
      << m.warnings.back();
}

TEST(MistypedPoint, IsNotToldOfADrawingThatIsRounded) {
  const Mechanism m = typed(drawn_four_bar("[110.01, 70.01]"));
  EXPECT_EQ(m.warnings.size(), 1U);  // the only point that does not agree to the last digit
  std::string text = drawn_four_bar("[110.01, 70.01]");
  text.replace(text.find("A = [25, 40]"), 12, "A = [25.01, 40]");
  EXPECT_TRUE(typed(text).warnings.empty());
}

}  // namespace
}  // namespace moivre::test
