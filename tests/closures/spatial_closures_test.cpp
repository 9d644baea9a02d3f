// SPDX-License-Identifier: MIT
// How many closures do the published spatial mechanisms have, by how few paths, and is the posture
// one came from among them?
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "../mechanism/in_unit.h"
#include "mechanisms.h"
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
                    QuickCount{"3-upu", 5}, QuickCount{"spherical-four-bar", 20},
                    QuickCount{"spherical-3-rrr", 3}, QuickCount{"3-rps", 3},
                    QuickCount{"general-6r", 3}, QuickCount{"manseur-doty", 3},
                    QuickCount{"puma-560", 3}, QuickCount{"ur5", 3}, QuickCount{"7r-loop", 3},
                    QuickCount{"bricard-driven", 5}, QuickCount{"delta", 1},
                    QuickCount{"delta-reduced", 5}, QuickCount{"delta-inverse", 5},
                    QuickCount{"dietmaier", 2}, QuickCount{"planar-platform", 1},
                    QuickCount{"platform-6-4", 1}, QuickCount{"platform-6-3", 1},
                    QuickCount{"octahedral-3-3", 1}),
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

/// Whether a body's rotation vector, three of the six coordinates of body number `body`, is zero.
bool is_not_turned(const VectorXd& q, std::size_t body) {
  return q.segment<3>(static_cast<Eigen::Index>(6 * (body - 1) + 3)).norm() < 1e-9;
}

// Its arms' ends and its rods' length give three spheres; the platform's place without turning is
// where they meet.
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

// A planar four-bar, three of its joints cylindrical: its links slide along the parallel axes. One
// part of it closes in complex numbers only, but the pose as drawn is assembled.
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

/// Two shafts, bent by 30 degrees, whose lines meet in the cross at the origin; the second one's
/// bearing is at x, y.
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

/// A chain of turns (R) and slides (P), each along another axis, whose last body is welded where
/// the joints put it at these values.
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

// Its first and last axes are parallel, and every two neighbours meet or are parallel: no dyad's
// 3-space leaves Study's quadric.
TEST(SpatialClosures, AnArmWithoutOffsetsHasEightWithItsToolStraightDown) {
  const std::array<std::array<Eigen::Vector3d, 2>, 6> joints{{{{{0, 0, 0}, {0, 0, 1}}},
                                                              {{{0, 0, 1}, {0, 1, 0}}},
                                                              {{{1, 0, 1.2}, {0, 1, 0}}},
                                                              {{{1.8, 0, 0.9}, {0.8, 0, -0.3}}},
                                                              {{{1.8, 0, 0.9}, {0.3, 0.8, -0.2}}},
                                                              {{{1.8, 0, 0.9}, {0, 0, 1}}}}};
  Mechanism mechanism = mechanism_file("7r-loop");
  mechanism.drivers.clear();
  mechanism.bodies.resize(joints.size());
  mechanism.joints.resize(joints.size());
  for (Body& body : mechanism.bodies) body.points.clear();
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const std::size_t next = (k + 1) % joints.size();
    Joint& joint = mechanism.joints[k];
    joint.at = {PointOf{k, mechanism.bodies[k].points.size()},
                PointOf{next, mechanism.bodies[next].points.size()}};
    joint.axis = {joints[k][1].normalized(), joints[k][1].normalized()};
    for (const std::size_t body : {k, next}) {
      BodyPoint& point = mechanism.bodies[body].points.emplace_back();
      point.name = "P" + std::to_string(k);
      point.at = joints[k][0];
    }
  }
  const ClosureResult result = closures_of(mechanism);
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 8U);
  EXPECT_EQ(result.closures.size(), 8U);
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

}  // namespace
}  // namespace moivre
