// SPDX-License-Identifier: MIT
// How many closures do the published spatial mechanisms have, by how few paths, and is the posture one came from among them?
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "../mechanism/in_unit.h"
#include "mechanisms.h"
#include "moivre/certify/certifier.h"
#include "moivre/mechanism/pose.h"
#include "moivre/numeric/random.h"
#include "spatial_counts.h"

namespace moivre {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A few of the list: the others are in bench/spatial_counts.cpp, over many seeds.
struct QuickCount {
  std::string file;
  std::uint64_t seeds;
};

const SpatialCount& count_of(const std::string& file) {
  const auto& counts = spatial_counts();
  return *std::find_if(counts.begin(), counts.end(),
                       [&](const SpatialCount& count) { return count.file == file; });
}

class SpatialCounts : public testing::TestWithParam<QuickCount> {};

TEST_P(SpatialCounts, AreMetForEverySeed) {
  const SpatialCount& published = count_of(GetParam().file);
  const Mechanism mechanism = mechanism_file(published.file);
  const Phi phi(mechanism);
  for (std::uint64_t seed = 1; seed <= GetParam().seeds; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, published.complex) << "seed " << seed;
    EXPECT_EQ(result.counts.real, published.real) << "seed " << seed;
    EXPECT_LE(result.paths.tracked, published.most_paths) << "seed " << seed;
    EXPECT_FALSE(result.moves);
    for (const Solution& root : result.solutions) {
      EXPECT_TRUE(!result.completeness || root.certified == true) << root.path;
    }
    for (const Closure& closure : result.closures) {
      EXPECT_LE(scaled_residual(phi, closure.q, 0), 1e-12) << closure.id;
      EXPECT_LE(closure.newton_iterations, 2) << closure.id;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Mechanisms, SpatialCounts,
    testing::Values(QuickCount{"rssr", 20}, QuickCount{"rccc", 5}, QuickCount{"bennett", 5},
                    QuickCount{"spherical-four-bar", 20}, QuickCount{"spherical-3-rrr", 3},
                    QuickCount{"3-rps", 3}, QuickCount{"general-6r", 3},
                    QuickCount{"manseur-doty", 3}, QuickCount{"puma-560", 3}, QuickCount{"ur5", 3},
                    QuickCount{"7r-loop", 3}, QuickCount{"bricard-driven", 5},
                    QuickCount{"delta", 1}, QuickCount{"delta-reduced", 5},
                    QuickCount{"delta-inverse", 5}, QuickCount{"dietmaier", 2},
                    QuickCount{"planar-platform", 1}, QuickCount{"platform-6-4", 1},
                    QuickCount{"platform-6-3", 1}, QuickCount{"octahedral-3-3", 1}),
    [](const auto& tested) {
      std::string name = tested.param.file;
      std::replace(name.begin(), name.end(), '-', '_');
      return "Of_" + name;
    });

/// Where the last body of an arm stands with its joints at these angles.
Isometry3d forward(const Mechanism& arm, const std::vector<double>& angles) {
  Isometry3d at = Isometry3d::Identity();
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const Joint& joint = arm.joints[k];
    const auto point = [&](std::size_t end) {
      return arm.bodies[joint.at[end].body].points[joint.at[end].point].at;
    };
    const Eigen::AngleAxisd turn(angles[k], Vector3d::UnitZ());
    Isometry3d step = Isometry3d::Identity();
    step.linear() = joint_frame(joint.axis[0]) * turn.toRotationMatrix() *
                    joint_frame(joint.axis[1]).transpose();
    step.translation() = point(0) - step.linear() * point(1);
    at = at * step;
  }
  return at;
}

/// The arm with its tool, the weld behind the joints, where these angles put it.
Mechanism holding(Mechanism arm, const std::vector<double>& angles) {
  Joint& weld = arm.joints.back();
  const Isometry3d hand = forward(arm, angles);
  const PointOf& tip = weld.at[1];
  arm.bodies[0].points[weld.at[0].point].at = hand * arm.bodies[tip.body].points[tip.point].at;
  const Eigen::AngleAxisd turn(hand.linear());
  weld.axis = {turn.axis(), turn.axis()};
  weld.turn_rad = turn.angle();
  return arm;
}

std::vector<double> random_angles(std::uint64_t pose) {
  std::vector<double> angles;
  for (std::uint64_t k = 0; k < 6; ++k) {
    angles.push_back(std::numbers::pi * (2 * random_unit(pose, RandomStream::test, k) - 1));
  }
  return angles;
}

/// Largest difference of the arm's angles from these, to the nearest turn.
double apart(const Mechanism& arm, const VectorXd& q, const std::vector<double>& angles) {
  double largest = 0;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double angle = joint_coordinate(arm, arm.joints[k], q).value();
    largest = std::max(largest, std::abs(std::remainder(angle - angles[k], 2 * std::numbers::pi)));
  }
  return largest;
}

class Arms : public testing::TestWithParam<std::pair<const char*, std::uint64_t>> {};

TEST_P(Arms, HaveTheirOwnPostureAmongAllOfThem) {
  constexpr std::uint64_t kPoses = 3;
  const auto& [file, complex] = GetParam();
  for (std::uint64_t pose = 1; pose <= kPoses; ++pose) {
    const std::vector<double> angles = random_angles(pose);
    const Mechanism arm = holding(mechanism_file(file), angles);
    const ClosureResult result = closures_of(arm);
    EXPECT_TRUE(result.complete) << "pose " << pose << ": " << result.message;
    EXPECT_EQ(result.counts.complex, complex) << "pose " << pose;
    double nearest = std::numbers::pi;
    for (const Closure& closure : result.closures) {
      nearest = std::min(nearest, apart(arm, closure.q, angles));
    }
    EXPECT_LE(nearest, 1e-9) << "pose " << pose;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Arms,
                         testing::Values(std::pair{"general-6r", 16U},
                                         std::pair{"manseur-doty", 16U}, std::pair{"puma-560", 8U},
                                         std::pair{"ur5", 8U}));

TEST(SpatialClosures, CalibratedArmsHaveTheSixteenOfTheGeneralOne) {
  for (const char* const file : {"puma-560", "ur5"}) {
    for (const double share : {1e-2, 1e-4}) {
      const ClosureResult result = closures_of(disturbed(mechanism_file(file), share));
      EXPECT_TRUE(result.complete) << file << ": " << result.message;
      EXPECT_EQ(result.counts.complex, 16U) << file << ", " << share;
    }
  }
}

TEST(SpatialClosures, PlatformsWhoseDoubleJointsSplitHaveForty) {
  for (const char* const file : {"platform-6-4", "platform-6-3"}) {
    const ClosureResult result = closures_of(disturbed(mechanism_file(file), 1e-2));
    EXPECT_TRUE(result.complete) << file << ": " << result.message;
    EXPECT_EQ(result.counts.complex, 40U) << file;
  }
}

TEST(SpatialClosures, GriffisAndDuffysPlatformMovesInOneDirection) {
  const ClosureResult result = closures_of(mechanism_file("griffis-duffy"));
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_TRUE(result.moves);
  EXPECT_EQ(result.moves->dimension, 1U);
}

TEST(SpatialClosures, BennettsLinkageDoesNotCloseWithOtherLengths) {
  const ClosureResult result = closures_of(disturbed(mechanism_file("bennett"), 1e-2));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 0U);
}

TEST(SpatialClosures, BricardsLinkageMovesInOneDirection) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(mechanism_file("bricard"), seed);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_TRUE(result.moves) << "seed " << seed;
    EXPECT_EQ(result.moves->dimension, 1U);
  }
}

TEST(SpatialClosures, BricardsLinkageDoesNotCloseWithOtherLengths) {
  for (const double share : {1e-2, 1e-9}) {
    const ClosureResult result = closures_of(disturbed(mechanism_file("bricard-driven"), share));
    EXPECT_TRUE(result.complete) << share << ": " << result.message;
    EXPECT_EQ(result.counts.complex, 0U) << share;
  }
}

/// Whether a body's rotation vector, three of the six coordinates of body number `body`, is zero.
bool is_not_turned(const VectorXd& q, std::size_t body) {
  return q.segment<3>(static_cast<Eigen::Index>(6 * (body - 1) + 3)).norm() < 1e-9;
}

// Its arms' ends and its rods' length give three spheres; the platform's place without turning is where they meet.
TEST(SpatialClosures, TwoPlacesOfADeltaPlatformAreNotTurned) {
  const Mechanism delta = mechanism_file("delta");
  const Mechanism reduced = mechanism_file("delta-reduced");
  std::vector<Vector3d> places;
  for (const Closure& closure : closures_of(delta).closures) {
    constexpr std::size_t kPlatform = 4;
    if (is_not_turned(closure.q, kPlatform)) places.push_back(closure.q.segment<3>(18));
  }
  const ClosureResult led = closures_of(reduced);
  ASSERT_EQ(places.size(), 2U);
  ASSERT_EQ(led.closures.size(), 2U);
  for (const Closure& closure : led.closures) {
    const Vector3d place = closure.q.tail<6>().head<3>();
    EXPECT_LT(std::min((place - places[0]).norm(), (place - places[1]).norm()), 1e-9);
  }
}

TEST(SpatialClosures, ALinkThatSpinsBetweenBallsHidesNoClosure) {
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

/// A MacPherson strut: the wheel's knuckle on a driven arm and a tie rod, and a line of it through the top mount.
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

// The knuckle turns about two balls, of which the upper one is at either of two places on its line; the tie rod leaves two poses of each.
TEST(SpatialClosures, AStrutHasTheSameWhetherItsRodIsABodyThatSpinsOrALine) {
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

// A knuckle whose tie rod is a body: that is one distance, and the knuckle is no three distances then.
TEST(SpatialClosures, ALinkOfThreeBallsWithARodOnOneOfThemHasItsClosures) {
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

// A planar four-bar, three of its joints cylindrical: its links slide along the parallel axes. One part of it closes in complex numbers only,
// but the pose as drawn is assembled.
TEST(SpatialClosures, AMechanismThatIsAssembledAsDrawnIsNotSaidToBeImpossible) {
  const Mechanism mechanism = mechanism_text(R"toml(title = "Planar four-bar in space"
space = "spatial"
[units]
length = "mm"
angle = "deg"
[ground.points]
O2 = [0, 0, 0]
O4 = [100, -20, 0]
[body.crank.points]
O2 = [0, 0, 0]
A = [0, 40, 0]
[body.coupler.points]
A = [0, 40, 0]
B = [110, 70, 0]
P = [50, 90, 0]
[body.rocker.points]
O4 = [100, -20, 0]
B = [110, 70, 0]
[[joint]]
type = "revolute"
at = ["ground.O2", "crank.O2"]
axis = [0, 0, 1]
name = "in"
[[joint]]
type = "cylindrical"
at = ["crank.A", "coupler.A"]
axis = [0, 0, 1]
name = "A"
[[joint]]
type = "cylindrical"
at = ["coupler.B", "rocker.B"]
axis = [0, 0, 1]
name = "B"
[[joint]]
type = "cylindrical"
at = ["ground.O4", "rocker.O4"]
axis = [0, 0, 1]
name = "out"
[[driver]]
angle = "in"
start = 0
velocity = 360
)toml");
  const ClosureResult result = closures_of(mechanism);
  ASSERT_TRUE(result.moves) << result.message;
  EXPECT_EQ(result.moves->dimension, 2U);
  EXPECT_LE(scaled_residual(Phi(mechanism), result.moves->pose, 0), 1e-12);
}

/// Two shafts, bent by 30 degrees, whose lines meet in the cross at the origin; the second one's bearing is at x, y.
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

// Half a turn of the cross leads from one to the other. All axes meet in a point, where the shifts of a loop of 100 leave rounding alone.
TEST(SpatialClosures, CardanShaftHasTwo) {
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

TEST(SpatialClosures, SphericalFourBarHasTwoWhereverItStands) {
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

// With bars of one length the top may be folded onto the base, where the second leg swings; two closures stand beside that.
TEST(SpatialClosures, SarrussLinkageHasTwoBesideItsFoldedPoses) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  const Mechanism mechanism = mechanism_text(R"toml(space = "spatial"
[units]
angle = "deg"
[ground.points]
A = [1, 0, 0]
D = [0, 1, 0]
[body.l1.points]
A = [1, 0, 0]
B = [2, 0, 1]
[body.l2.points]
B = [2, 0, 1]
C = [1, 0, 2]
[body.top.points]
C = [1, 0, 2]
F = [0, 1, 2]
[body.l3.points]
D = [0, 1, 0]
E = [0, 2, 1]
[body.l4.points]
E = [0, 2, 1]
F = [0, 1, 2]
[[joint]]
type = "revolute"
at = ["ground.A", "l1.A"]
axis = [0, 1, 0]
name = "a"
[[joint]]
type = "revolute"
at = ["l1.B", "l2.B"]
axis = [0, 1, 0]
[[joint]]
type = "revolute"
at = ["l2.C", "top.C"]
axis = [0, 1, 0]
[[joint]]
type = "revolute"
at = ["ground.D", "l3.D"]
axis = [1, 0, 0]
[[joint]]
type = "revolute"
at = ["l3.E", "l4.E"]
axis = [1, 0, 0]
[[joint]]
type = "revolute"
at = ["l4.F", "top.F"]
axis = [1, 0, 0]
[[driver]]
angle = "a"
start = 10
)toml");
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

// Overconstrained: what rounding leaves of its spare equations has to be seen beside their own terms, in millimetres as well.
TEST(SpatialClosures, BennettsLinkageClosesAtEveryAngleInEveryUnit) {
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

TEST(SpatialClosures, AreAsManyInEveryUnit) {
  for (const char* name : {"bennett", "rccc", "spherical-four-bar", "general-6r", "3-rps"}) {
    const Mechanism mechanism = mechanism_file(name);
    const ClosureResult known = closures_of(mechanism);
    for (const double unit : {1e-4, 100.0, 1e5}) {
      const ClosureResult result = closures_of(test::in_unit(mechanism, unit));
      EXPECT_EQ(result.complete, known.complete) << name << ": " << result.message;
      EXPECT_EQ(result.counts.real, known.counts.real) << name << " in " << unit;
      EXPECT_EQ(result.counts.complex, known.counts.complex) << name << " in " << unit;
    }
  }
}

TEST(SpatialClosures, NothingThatHangsFromOneJointHidesAClosure) {
  const std::vector<std::pair<std::string, std::string>> joints{
      {"revolute", "axis = [0, 0.6, 0.8]"},
      {"cylindrical", "axis = [0, 0.6, 0.8]\nlimits = [0.5, 1]"},
      {"prismatic", "axis = [0, 0.6, 0.8]\nturn = 0.3\nlimits = [0.5, 1]"},
      {"screw", "axis = [0, 0.6, 0.8]\npitch = 0.2"},
      {"planar", "axis = [0, 0.6, 0.8]"},
      {"universal", "axis = [[0, 0.6, 0.8], [0, 1, 0]]"},
      {"universal", "axis = [[0, 0.6, 0.8], [0, 0.6, 0.8]]"},
      {"point-on-line", "axis = [0, 0.6, 0.8]\nlimits = [0.5, 1]"},
      {"point-on-plane", "axis = [0, 0.6, 0.8]"},
      {"rod", "length = 1.5"},
      {"spherical", ""}};
  for (const auto& [type, keys] : joints) {
    const Mechanism mechanism =
        mechanism_text(std::string(test::kSpinningCoupler) +
                       "[body.tail.points]\nT = [0.1, 0.2, 0.3]\n[[joint]]\ntype = \"" + type +
                       "\"\nat = [\"rocker.B\", \"tail.T\"]\n" + keys + "\n");
    const ClosureResult result = closures_of(mechanism);
    EXPECT_TRUE(result.complete) << type << ": " << result.message;
    EXPECT_FALSE(result.moves) << type;
    EXPECT_EQ(result.closures.size(), 2U) << type;
    ASSERT_EQ(result.idle.size(), 2U) << type;
    EXPECT_EQ(result.idle[0].body, "tail");
    for (const Closure& closure : result.closures) {
      EXPECT_LE(scaled_residual(Phi(mechanism), closure.q, 0), 1e-12) << type;
      const Joint& tail = mechanism.joints.back();
      if (tail.limits) {
        EXPECT_NEAR(joint_coordinate(mechanism, tail, closure.q).value(), 0.5, 1e-12) << type;
      }
    }
  }
}

TEST(SpatialClosures, AnArmWithoutAToolPoseMoves) {
  Mechanism arm = mechanism_file("puma-560");
  arm.joints.pop_back();
  const ClosureResult result = closures_of(arm);
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_TRUE(result.moves);
  EXPECT_EQ(result.moves->dimension, 6U);
}

/// A chain of turns (R) and slides (P), each along another axis, whose last body is welded where the joints put it at these values.
Mechanism held_chain(const std::string& kinds, const std::vector<double>& values) {
  const char* const axes[] = {"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]", "[0.6, 0, 0.8]",
                              "[0, 0.6, 0.8]"};
  std::string points = "[ground.points]\nO = [0, 0, 0]\nT = [0, 0, 0]\n";
  std::string joints;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const std::string before = k == 0 ? "ground.O" : "b" + std::to_string(k - 1) + ".B";
    points += "[body.b" + std::to_string(k) + ".points]\nA = [0, 0, 0]\nB = [1, 0.5, 0.25]\n";
    joints += std::string("[[joint]]\ntype = \"") + (kinds[k] == 'R' ? "revolute" : "prismatic") +
              "\"\nat = [\"" + before + "\", \"b" + std::to_string(k) + ".A\"]\naxis = " + axes[k] +
              "\n";
  }
  const std::string last = "b" + std::to_string(kinds.size() - 1);
  Mechanism chain = mechanism_text("space = \"spatial\"\n" + points + joints +
                                   "[[joint]]\ntype = \"weld\"\nat = [\"ground.T\", \"" + last +
                                   ".B\"]\naxis = [0, 0, 1]\n");
  Isometry3d at = Isometry3d::Identity();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const Joint& joint = chain.joints[k];
    at.translate(chain.bodies[joint.at[0].body].points[joint.at[0].point].at);
    if (kinds[k] == 'R') {
      at.rotate(Eigen::AngleAxisd(values[k], joint.axis[0]));
    } else {
      at.translate(values[k] * joint.axis[0]);
    }
  }
  const Eigen::AngleAxisd turn(at.linear());
  Joint& weld = chain.joints.back();
  const PointOf& tip = weld.at[1];
  chain.bodies[0].points[1].at = at * chain.bodies[tip.body].points[tip.point].at;
  weld.axis = {turn.axis(), turn.axis()};
  weld.turn_rad = turn.angle();
  return chain;
}

TEST(SpatialClosures, SlidesInARowHideNoClosure) {
  const std::vector<double> values{0.3, -0.7, 0.4, 0.9, -0.5};
  for (const std::string kinds :
       {"PPP", "RPP", "PPR", "PRP", "PPRR", "RPPR", "RRPP", "PPRP", "RPPRR"}) {
    SCOPED_TRACE(kinds);
    const Mechanism chain = held_chain(kinds, values);
    const ClosureResult result = closures_of(chain);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_FALSE(result.closures.empty());
    double nearest = 1;
    for (const Closure& closure : result.closures) {
      double farthest = 0;
      for (std::size_t k = 0; k < kinds.size(); ++k) {
        const double value = joint_coordinate(chain, chain.joints[k], closure.q).value();
        farthest = std::max(farthest, std::abs(value - values[k]));
      }
      nearest = std::min(nearest, farthest);
    }
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(SpatialClosures, SlidesDoNotTurnWhatTheyHold) {
  Mechanism chain = held_chain("PPP", {0.3, -0.7, 0.4});
  chain.joints.back().turn_rad = 0.1;
  const ClosureResult result = closures_of(chain);
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 0U);
}

TEST(SpatialClosures, OutOfReachCannotBeAssembled) {
  Mechanism arm = mechanism_file("puma-560");
  arm.bodies[0].points[1].at = {5, 0, 0};
  const ClosureResult result = closures_of(arm);
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.real, 0U);
  EXPECT_TRUE(result.closures.empty());
  EXPECT_FALSE(result.moves);
}

// Two roots of the three equations that are solved lie 1e-16 apart, at one regular pose: the fourth leaves one of them.
TEST(SpatialClosures, AreToldOnceWhereRoundingPartsARootOfTheSolvedEquations) {
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

}  // namespace
}  // namespace moivre
