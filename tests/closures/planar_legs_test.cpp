// SPDX-License-Identifier: MIT
// Do legs of three parallel hinges let what they join move like a planar joint, and stand in both
// their postures?
#include <gtest/gtest.h>

#include <string>

#include "mechanisms.h"
#include "spatial_counts.h"

namespace moivre {
namespace {

/// A body on three rods and `guide`.
std::string on_rods(const std::string& guide) {
  return R"toml(space = "spatial"
[ground.points]
A = [0, 0, 0]
P = [0, 0, 0.1]
R1 = [3, 0.2, -0.5]
R2 = [-1, 2.5, 0.3]
R3 = [-0.7, -2.2, 0.4]
[body.top.points]
C = [0, 0, 0]
R1 = [0.7, 0.1, 0.3]
R2 = [-0.2, 0.9, -0.4]
R3 = [0.1, -0.6, 0.5]
[[joint]]
type = "rod"
at = ["ground.R1", "top.R1"]
length = 2
[[joint]]
type = "rod"
at = ["ground.R2", "top.R2"]
length = 2.3
[[joint]]
type = "rod"
at = ["ground.R3", "top.R3"]
length = 2.1
)toml" + guide;
}

// The second link is turned over, so that its offset goes down.
const char* const kLeg = R"toml([body.low.points]
A = [0, 0, 0]
B = [1.5, 0, 0.3]
[body.high.points]
B = [0, 0, 0]
C = [0, 1.2, 0.2]
[[joint]]
type = "revolute"
at = ["ground.A", "low.A"]
axis = [0, 0, 1]
[[joint]]
type = "revolute"
at = ["low.B", "high.B"]
axis = [[0, 0, -1], [0, 0, 1]]
[[joint]]
type = "revolute"
at = ["high.C", "top.C"]
axis = [[0, 0, 1], [0.6, 0, 0.8]]
)toml";

TEST(PlanarLegs, StandTwoWaysInEachPoseOfAPlanarJoint) {
  const ClosureResult joint = closures_of(mechanism_text(on_rods(R"toml([[joint]]
type = "planar"
at = ["ground.P", "top.C"]
axis = [[0, 0, -1], [0.6, 0, 0.8]]
)toml")));
  const Mechanism mechanism = mechanism_text(on_rods(kLeg));
  const ClosureResult leg = closures_of(mechanism);
  ASSERT_TRUE(joint.complete && leg.complete) << joint.message << "; " << leg.message;
  EXPECT_EQ(joint.counts.complex, 6U);
  EXPECT_EQ(leg.counts.complex, 2 * joint.counts.complex);
  EXPECT_EQ(leg.counts.real, 2 * joint.counts.real);
  EXPECT_LE(leg.paths.tracked, 100U);
  for (const Closure& closure : leg.closures) {
    EXPECT_LE(scaled_residual(Phi(mechanism), closure.q, 0), 1e-12);
  }
}

/// A leg of a Tripteron along `axis`: a driven slide from the ground and three hinges.
std::string leg_along(const std::string& axis, const std::string& name, const std::string& slider,
                      const std::string& elbow, const std::string& slide) {
  const auto joint = [&](const std::string& type, const std::string& from, const std::string& to) {
    return "[[joint]]\ntype = \"" + type + "\"\nname = \"" + type + from + "\"\nat = [\"" + from +
           "\", \"" + to + "\"]\naxis = " + axis + "\n";
  };
  const std::string x = name + "1";
  const std::string low = name + "2";
  const std::string high = name + "3";
  return "[body." + x + ".points]\nS = " + slider + "\n[body." + low + ".points]\nS = " + slider +
         "\nE = " + elbow + "\n[body." + high + ".points]\nE = " + elbow + "\nH = [1, 1.6, 1.3]\n" +
         joint("prismatic", "ground." + name, x + ".S") + joint("revolute", x + ".S", low + ".S") +
         joint("revolute", low + ".E", high + ".E") + joint("revolute", high + ".H", "top.H") +
         "[[driver]]\nslide = \"prismaticground." + name + "\"\nstart = " + slide + "\n";
}

// Each leg keeps one axis of the top and its place along it: of nine equations for six unknowns
// three are spare. By half angles they had 960 paths, some of them undecided.
TEST(PlanarLegs, OfATripteronStandEightWays) {
  const Mechanism mechanism =
      mechanism_text(
          R"toml(space = "spatial"
[ground.points]
X = [0, 4, 0]
Y = [0, 0, 4]
Z = [4, 0, 0]
[body.top.points]
H = [1, 1.6, 1.3]
)toml" + leg_along("[1, 0, 0]", "X", "[1, 4, 0]", "[1, 2.5, 1.8]", "1") +
          leg_along("[0, 1, 0]", "Y", "[0, 1.6, 4]", "[1.8, 1.6, 2.5]", "1.6") +
          leg_along("[0, 0, 1]", "Z", "[4, 0, 1.3]", "[2.5, 1.8, 1.3]", "1.3"));
  const ClosureResult result = closures_of(mechanism);
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 8U);
  EXPECT_EQ(result.closures.size(), 8U);
  EXPECT_LE(result.paths.tracked, 100U);
}

}  // namespace
}  // namespace moivre
