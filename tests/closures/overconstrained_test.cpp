// SPDX-License-Identifier: MIT
// Are the closures found of loops with more equations than unknowns, each once, and none where
// these contradict each other?
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "../mechanism/in_unit.h"
#include "mechanisms.h"
#include "moivre/certify/certifier.h"
#include "sarrus.h"
#include "spatial_counts.h"

namespace moivre {
namespace {

using Eigen::Vector3d;

TEST(OverconstrainedClosures, BennettsLinkageDoesNotCloseWithOtherLengths) {
  const ClosureResult result = closures_of(disturbed(mechanism_file("bennett"), 1e-2));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 0U);
}

TEST(OverconstrainedClosures, BricardsLinkageMovesInOneDirection) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(mechanism_file("bricard"), seed);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_TRUE(result.moves) << "seed " << seed;
    EXPECT_EQ(result.moves->dimension, 1U);
  }
}

// Rounded far from the origin it would not move, and points of its motion would be told as isolated
// closures.
TEST(OverconstrainedClosures, BricardsLinkageMovesWhereverItStands) {
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(12.3, -4.7, 8.1), Eigen::Vector3d(6.3, 0, 0)}) {
    Mechanism mechanism = mechanism_file("bricard");
    const double span = 6;
    mechanism.bodies[0].points[0].at = place;
    mechanism.bodies[0].points[1].at = {std::round(10 * (place.x() - span)) / 10, place.y(),
                                        place.z()};
    const ClosureResult result = closures_of(mechanism);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(result.moves) << place.transpose();
    EXPECT_EQ(result.counts.complex, 0U) << place.transpose();
  }
}

// A hinge's axis that is no fraction is rounded, and its motion with it: what is left of the motion
// is no isolated closure.
TEST(OverconstrainedClosures, PointsOfARoundedMotionAreNoIsolatedClosures) {
  Mechanism mechanism = mechanism_file("bricard");
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()) *
                                Eigen::AngleAxisd(-1.1, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  for (BodyPoint& point : mechanism.bodies[0].points) point.at = turn * point.at;
  for (Joint& joint : mechanism.joints) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (joint.at[k].body == 0) joint.axis[k] = turn * joint.axis[k];
    }
  }
  EXPECT_EQ(closures_of(mechanism).counts.complex, 0U);
}

TEST(OverconstrainedClosures, BricardsLinkageDoesNotCloseWithOtherLengths) {
  for (const double share : {1e-2, 1e-9}) {
    const ClosureResult result = closures_of(disturbed(mechanism_file("bricard-driven"), share));
    EXPECT_TRUE(result.complete) << share << ": " << result.message;
    EXPECT_EQ(result.counts.complex, 0U) << share;
  }
}

std::string cardan_shaft(const std::string& x, const std::string& y, const std::string& axis) {
  return R"toml(space = "spatial"
[units]
angle = "deg"
[ground.points]
A = [-100, 0, 0]
B = [)toml" +
         x + ", " + y + R"toml(, 0]
[body.in.points]
A = [-100, 0, 0]
C = [0, 0, 0]
[body.out.points]
B = [)toml" +
         x + ", " + y + R"toml(, 0]
C = [0, 0, 0]
[[joint]]
type = "revolute"
at = ["ground.A", "in.A"]
axis = [1, 0, 0]
name = "in"
[[joint]]
type = "universal"
at = ["in.C", "out.C"]
axis = [[0, 1, 0], [0, 0, 1]]
[[joint]]
type = "revolute"
at = ["ground.B", "out.B"]
axis = )toml" +
         axis + R"toml(
[[driver]]
angle = "in"
start = 0
velocity = 360
)toml";
}

// Half a turn of the cross leads from one to the other. All axes meet in a point, where the shifts
// of a loop of 100 leave rounding alone.
TEST(OverconstrainedClosures, CardanShaftHasTwo) {
  for (const Mechanism& mechanism :
       {mechanism_text(cardan_shaft("86.6025403784", "50", "[0.866025403784, 0.5, 0]")),
        mechanism_text(cardan_shaft("86.60254037844386", "50", "[0.8660254037844386, 0.5, 0]")),
        mechanism_text(cardan_shaft("80", "60", "[0.8, 0.6, 0]"))}) {
    for (const double time : {0.0, 0.1, 0.25, 0.61}) {
      const ClosureResult result = closures_of(mechanism, 1, time);
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(result.counts.complex, 2U) << time;
      EXPECT_EQ(result.closures.size(), 2U) << time;
    }
  }
}

TEST(OverconstrainedClosures, CardanShaftThatMissesIsToldItsMisfit) {
  for (const double miss : {1e-10, 1e-9, 1e-6}) {
    Mechanism mechanism = mechanism_text(cardan_shaft("80", "60", "[4, 3, 0]"));
    mechanism.bodies[0].points[1].at.z() = miss;
    const ClosureResult result = closures_of(mechanism, 1, 0.1);
    EXPECT_TRUE(result.complete) << miss << ": " << result.message;
    EXPECT_EQ(result.counts.complex, 0U) << miss;
    ASSERT_TRUE(result.least_misfit) << miss;
    EXPECT_LE(*result.least_misfit, miss) << miss;
    mechanism.fit = miss;
    EXPECT_GE(closures_of(mechanism, 1, 0.1).counts.fitted, 1U) << miss;
  }
}

// Along the axes nothing is left to solve: the loop's equation is a number.
TEST(OverconstrainedClosures, AJointThatMissesAlongItsAxesIsToldItsMisfit) {
  constexpr double kMiss = 1e-9;
  Mechanism mechanism = mechanism_text(R"toml(space = "spatial"
[ground.points]
O = [0, 0, 0]
P = [0, 0, 0]
[body.input.points]
O = [0, 0, 0]
[body.output.points]
O = [0, 0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "input.O"]
axis = [0, 0, 1]
name = "in"
[[joint]]
type = "revolute"
at = ["ground.P", "output.O"]
axis = [[0.6, 0, 0.8], [0, 0, 1]]
[[joint]]
type = "universal"
at = ["input.O", "output.O"]
axis = [[0, 1, 0], [1, 0, 0]]
[[driver]]
angle = "in"
start = 0.4
)toml");
  mechanism.bodies[0].points[1].at.z() = kMiss;
  const ClosureResult result = closures_of(mechanism);
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 0U);
  ASSERT_TRUE(result.least_misfit);
  EXPECT_LE(*result.least_misfit, kMiss);
  mechanism.fit = kMiss;
  EXPECT_GE(closures_of(mechanism).counts.fitted, 1U);
}

// A dyad's coordinates, which are solved first, have a set of roots at which its slide is
// infinitely long: no closures.
TEST(OverconstrainedClosures, HobsonsCouplingOfOneBentRodHasTwo) {
  const Mechanism mechanism = mechanism_text(R"toml(space = "spatial"
[ground.points]
A = [3, 0, 0]
D = [0, 3, 0]
[body.in.points]
A = [3, 0, 0]
B = [2, 0.6, 0.8]
[body.rod.points]
B = [1.5, 0.6, 0.8]
C = [0.6, 2, 0.8]
[body.out.points]
C = [0.6, 1.5, 0.8]
D = [0, 3, 0]
[[joint]]
type = "revolute"
at = ["ground.A", "in.A"]
axis = [1, 0, 0]
name = "in"
[[joint]]
type = "cylindrical"
at = ["in.B", "rod.B"]
axis = [1, 0, 0]
[[joint]]
type = "cylindrical"
at = ["rod.C", "out.C"]
axis = [0, 1, 0]
[[joint]]
type = "revolute"
at = ["out.D", "ground.D"]
axis = [0, 1, 0]
[[driver]]
angle = "in"
start = 0
velocity = 0.5
)toml");
  for (const double time : {0.0, 0.3}) {
    const ClosureResult result = closures_of(mechanism, 1, time);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_FALSE(result.moves);
    EXPECT_EQ(result.counts.complex, 2U) << time;
    EXPECT_EQ(result.closures.size(), 2U) << time;
  }
}

TEST(OverconstrainedClosures, SphericalFourBarHasTwoWhereverItStands) {
  for (const double shift : {0.0, 0.3, 50.7, 1e4}) {
    Mechanism mechanism = mechanism_file("spherical-four-bar");
    mechanism.guess.clear();
    for (BodyPoint& point : mechanism.bodies[0].points) {
      point.at += shift * Eigen::Vector3d(1, 0.7, -0.3);
    }
    const ClosureResult result = closures_of(mechanism);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 2U) << shift;
    EXPECT_EQ(result.closures.size(), 2U) << shift;
  }
}

// With bars of one length the top may be folded onto the base, where the second leg swings; two
// closures stand beside that.
TEST(OverconstrainedClosures, SarrussLinkageHasTwoBesideItsFoldedPoses) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  const Mechanism mechanism = mechanism_text(sarrus_text("start = 10"));
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(result.moves);
    ASSERT_EQ(result.closures.size(), 2U) << seed;
    EXPECT_EQ(result.counts.complex, 2U) << seed;
    for (const Closure& closure : result.closures) {
      EXPECT_GT(closure.smallest_singular_value, 0.01);
      EXPECT_LE(scaled_residual(Phi(mechanism), closure.q, 0), 1e-12);
    }
  }
}

// Overconstrained: what rounding leaves of its spare equations has to be seen beside their own
// terms, in millimetres as well.
TEST(OverconstrainedClosures, BennettsLinkageClosesAtEveryAngleInEveryUnit) {
  const Mechanism mechanism = mechanism_text(R"toml(title = "Bennett"
space = "spatial"
[units]
length = "mm"
angle = "deg"
[ground.points]
J0 = [0, 0, 0]
J1 = [34.20201433256688, 93.96926207859083, 0.0]
[body.l1.points]
J1 = [34.20201433256688, 93.96926207859083, 0.0]
J2 = [-61.547952991693464, -12.373653417768352, 44.979196092608]
[body.l2.points]
J2 = [-61.547952991693464, -12.373653417768352, 44.979196092608]
J3 = [-150.0, 0, 0]
[body.l3.points]
J3 = [-150.0, 0, 0]
J0 = [0, 0, 0]
[[joint]]
type = "revolute"
at = ["l3.J0", "ground.J0"]
axis = [0, 0, 1]
name = "J0"
[[joint]]
type = "revolute"
at = ["ground.J1", "l1.J1"]
axis = [0.6040227735550536, -0.21984631039295421, 0.766044443118978]
name = "J1"
[[joint]]
type = "revolute"
at = ["l1.J2", "l2.J2"]
axis = [-0.29986130728405325, 0.587799197315435, 0.7513822595917664]
name = "J2"
[[joint]]
type = "revolute"
at = ["l2.J3", "l3.J3"]
axis = [1.942890293094024e-16, 0.9641814145298088, 0.26524366132915744]
name = "J3"
[[driver]]
angle = "J1"
start = 0
velocity = 360
)toml");
  for (const double unit : {1e-2, 1.0, 1e3}) {
    for (const double time : {0.1, 0.25, 0.5, 0.75}) {
      const ClosureResult result = closures_of(test::in_unit(mechanism, unit), 1, time);
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(result.counts.real, 1U) << unit << ", t = " << time;
    }
  }
}

// Two roots of the three equations that are solved lie 1e-16 apart, at one regular pose: the fourth
// leaves one of them.
TEST(OverconstrainedClosures, AreToldOnceWhereRoundingPartsARootOfTheSolvedEquations) {
  const Mechanism mechanism = mechanism_text(R"toml(space = "spatial"
[ground.points]
P0 = [0, -1, 1]
P1 = [-1, -1, -1]
[body.b1.points]
P0 = [-1, -2, 2]
P1 = [0, -2, 1]
[body.b2.points]
P0 = [0, -1, -0.912]
P1 = [-1, -2, 2]
[body.b3.points]
P0 = [0.566, -1, -1]
P1 = [0, -2, 1]
[[joint]]
type = "cylindrical"
name = "J0"
at = ["ground.P0", "b2.P0"]
axis = [[0, 0, 1], [0, 0, 1]]
[[joint]]
type = "spherical"
name = "J1"
at = ["b2.P1", "b1.P0"]
[[joint]]
type = "prismatic"
name = "J2"
at = ["ground.P1", "b3.P0"]
axis = [[1, 0, 0], [1, 0, 0]]
[[joint]]
type = "universal"
name = "J3"
at = ["b3.P1", "b1.P1"]
axis = [[1, 0, 0], [0, 1, 0]]
[[driver]]
slide = "J0"
start = -1.912
[[driver]]
slide = "J2"
start = 1.566
)toml");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.closures.size(), 4U);
  }
}

/// Cranks of 3 about pivots 4 apart, lying in line with the coupler, whose pins are `apart`;
/// rounded they do not close at the fold.
std::string folded_cranks(int cranks, const std::string& apart) {
  std::string text = "[ground.points]\nO0 = [0, 0]\nO1 = [4, 0]\nO2 = [8, 0]\n";
  std::string joints;
  std::string pins = "[body.coupler.points]\nA0 = [0, 0]\n";
  for (int k = 0; k < cranks; ++k) {
    const std::string n = std::to_string(k);
    text += "[body.crank" + n + ".points]\nO" + n + " = [0, 0]\nA" + n + " = [3, 0]\n";
    joints += "[[joint]]\ntype = \"revolute\"\nat = [\"ground.O" + n + "\", \"crank" + n + ".O" +
              n + "\"]\n[[joint]]\ntype = \"revolute\"\nat = [\"crank" + n + ".A" + n +
              "\", \"coupler.A" + n + "\"]\n";
  }
  pins += "A1 = [" + apart + ", 0]\n";
  if (cranks > 2) pins += "A2 = [8, 0]\n";
  return text + pins + joints + "[[driver]]\nangle = \"crank0\"\nstart = 0\n";
}

TEST(Fit, TakesAFoldThatRoundedLengthsKeepFromClosing) {
  for (const int cranks : {2, 3}) {
    for (const char* apart : {"4.001", "3.999"}) {
      const std::string text = folded_cranks(cranks, apart);
      Mechanism mechanism = mechanism_text(text);
      mechanism.fit = 0.005;
      const ClosureResult result = find_closures(mechanism, *make_cvode_tracker());
      EXPECT_TRUE(result.complete) << result.message;
      const bool is_there =
          std::any_of(result.closures.begin(), result.closures.end(), [](const Closure& closure) {
            return closure.misfit <= 0.005 && closure.q.cwiseAbs().tail(1)[0] < 0.3;
          });
      EXPECT_TRUE(is_there) << cranks << " cranks, " << apart << ": " << result.message;
    }
  }
}

}  // namespace
}  // namespace moivre
