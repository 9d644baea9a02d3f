// SPDX-License-Identifier: MIT
// Is every pose within fit told, as a closure or as one that hangs together with a closure that may
// move so far?
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mechanisms.h"
#include "moivre/closures/same_pose.h"
#include "within_fit.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

/// Crank and rocker of the lengths `crank` and `rocker`, a coupler between them; the pivots are
/// `apart`. Driven is the crank.
Mechanism four_bar(const std::string& crank, const std::string& coupler, const std::string& rocker,
                   const std::string& apart, const std::string& angle, double fit) {
  Mechanism mechanism = mechanism_text(R"toml(
[ground.points]
A = [0, 0]
D = [)toml" + apart + R"toml(, 0]
[body.crank.points]
A = [0, 0]
B = [)toml" + crank + R"toml(, 0]
[body.coupler.points]
B = [0, 0]
C = [)toml" + coupler + R"toml(, 0]
[body.rocker.points]
D = [0, 0]
C = [)toml" + rocker + R"toml(, 0]
[[joint]]
type = "revolute"
at = ["ground.A", "crank.A"]
[[joint]]
type = "revolute"
at = ["crank.B", "coupler.B"]
[[joint]]
type = "revolute"
at = ["coupler.C", "rocker.C"]
[[joint]]
type = "revolute"
at = ["rocker.D", "ground.D"]
[[driver]]
angle = "crank"
start = )toml" + angle + "\n");
  mechanism.fit = fit;
  return mechanism;
}

// Crank's end on the rocker's pivot, coupler and rocker alike: they turn together about it. Typed
// with other lengths no root is near.
TEST(Fit, ARhombusFoldedUponItselfMovesAllAround) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result =
        closures_of(four_bar("2", "3.001", "3", "2.0004", "0.0002", 0.005), seed);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_EQ(result.closures.size(), 1U) << result.message;
    EXPECT_GT(*result.closures.front().play, 3) << result.message;
    EXPECT_NE(result.message.find("within fit closure A can move"), std::string::npos);
  }
}

TEST(Fit, AtAFoldTwoClosuresHangTogetherAndReachTheRootOfFit) {
  for (const double fit : {1e-3, 1e-5, 1e-7}) {
    const Mechanism mechanism = four_bar("2", "3", "4", "5", "3.141592653589793", fit);
    const ClosureResult result = closures_of(mechanism);
    ASSERT_EQ(result.closures.size(), 1U) << result.message;
    const double play = *result.closures.front().play;
    EXPECT_GT(play, 0.5 * std::sqrt(fit)) << fit;
    EXPECT_LT(play, 5 * std::sqrt(fit)) << fit;
  }
}

// Two lines cross at an angle of 5e-7: within fit the block goes along both without end. Only what
// is within ten lengths of the mechanism hung together, and play was measured by the far pose.
TEST(Fit, WhatSlidesWithoutEndIsOneClosure) {
  const Mechanism mechanism = mechanism_text(R"toml(
fit = 0.005
[ground.points]
A = [0, 0]
B = [1, 1]
[body.block.points]
C = [0, 0]
[[joint]]
type = "prismatic"
at = ["ground.A", "block.C"]
along = [1, 1]
[[joint]]
type = "slot"
at = ["ground.B", "block.C"]
along = [1, 1.000001]
)toml");
  const ClosureResult result = closures_of(mechanism);
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.closures.size(), 1U) << result.message;
  EXPECT_GT(*result.closures.front().play, 100);
  const Phi phi(mechanism);
  const WithinFit within(phi, *mechanism.fit, 0);
  const VectorXd& here = result.closures.front().q;
  for (const double far : {-60.0, 60.0}) {
    const VectorXd there = here + far * Eigen::Vector3d(1, 1, 0);
    EXPECT_TRUE(within.joins(here, there)) << far;
    EXPECT_TRUE(within.joins(there, here)) << far;
    EXPECT_LT((there - here).norm(), 1.5 * *result.closures.front().play);
  }
}

// The crank's pin and its slot are 0.008 apart, 40 from where the crank turns: to 0.0027 at each of
// three rows. Least squares in lengths of 3 leave nearly all of it to the crank's angle.
TEST(Fit, TakesWhatLeastSquaresShareOutBadly) {
  const auto mechanism_within = [](const std::string& fit) {
    return mechanism_text("fit = " + fit + R"toml(
[ground.points]
O = [0, 0]
A = [1, 0.008]
B = [1, 0]
C = [2, 0]
[body.crank.points]
O = [0, 0]
P = [40, 0]
[body.rocker.points]
B = [0, 0]
D = [1, 1]
[body.rod.points]
D = [0, 0]
C = [1, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "slot"
at = ["ground.A", "crank.P"]
along = [1, 0]
[[joint]]
type = "revolute"
at = ["ground.B", "rocker.B"]
[[joint]]
type = "revolute"
at = ["rocker.D", "rod.D"]
[[joint]]
type = "revolute"
at = ["rod.C", "ground.C"]
[[driver]]
angle = "crank"
start = 0
)toml");
  };
  for (const std::string fit : {"0.005", "0.003"}) {
    const ClosureResult result = closures_of(mechanism_within(fit));
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_EQ(result.closures.size(), 2U) << result.message;
    for (const Closure& closure : result.closures) EXPECT_LE(closure.misfit, std::stod(fit));
  }
  EXPECT_TRUE(closures_of(mechanism_within("0.0026")).closures.empty());
}

// Axes of slide and hinges are parallel but for rounding, so that a slide goes on without end. All
// along it rows have to miss by 0.0047 at least, and fit is 0.005: what least squares leave to a
// row is shared out at every step, or each place that they come to is a closure, 51 of them.
TEST(Fit, ALongValleyThatIsBarelyWithinItHangsTogether) {
  const ClosureResult result = closures_of(mechanism_text(R"toml(
space = "spatial"
fit = 0.005
[ground.points]
P0 = [60.0, 40.0, -60.0]
P9 = [40.0, -60.0, 40.0]
[body.b1.points]
P1 = [77.049, -18.206, 52.569]
P2 = [-35.458, 40.644, 35.866]
[body.b2.points]
P3 = [-25.533, 18.501, -49.673]
P4 = [56.345, -8.818, 21.387]
[body.b3.points]
P5 = [-57.497, 25.098, 0.332]
P6 = [-13.727, -77.47, 27.971]
[body.b4.points]
P7 = [65.099, 24.006, 46.714]
P8 = [-74.725, -7.5, -29.816]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [[1.0, 0.0, 0.0], [0.752, -0.642, -0.147]]
[[joint]]
type = "prismatic"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[0.752, -0.642, -0.147], [0.785, -0.074, 0.616]]
turn = 0.694
[[joint]]
type = "spherical"
name = "j2"
at = ["b2.P4", "b3.P5"]
[[joint]]
type = "revolute"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[0.479, 0.48, 0.734], [0.35, -0.714, -0.607]]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [[0.35, -0.714, -0.607], [0.0, 0.6, 0.8]]
[[driver]]
angle = "j0"
start = -0.42297418477871085
)toml"));
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_FALSE(result.closures.empty());
  EXPECT_LE(result.closures.size(), 3U);
  for (const Closure& closure : result.closures) EXPECT_GT(*closure.play, 2);
}

// Of the path to a slide that is infinitely long nothing is known. The pose that the loop was drawn
// in was not looked for then.
TEST(Fit, IsLookedIntoWherePathsFail) {
  const ClosureResult result = closures_of(mechanism_text(R"toml(
space = "spatial"
fit = 0.005
[ground.points]
P0 = [-6.0, 4.0, -6.0]
P11 = [4.0, -4.0, -2.0]
[body.b1.points]
P1 = [5.759, -3.885, -4.82]
P2 = [2.185, -5.564, -0.303]
[body.b2.points]
P3 = [3.357, -3.793, -2.324]
P4 = [-3.357, -4.853, 0.283]
[body.b3.points]
P5 = [3.504, -1.341, 6.321]
P6 = [1.144, 5.88, 1.601]
[body.b4.points]
P7 = [-5.567, 4.445, -2.194]
P8 = [0.849, -0.616, -3.299]
[body.b5.points]
P9 = [3.882, -2.101, 3.354]
P10 = [3.213, -3.137, 4.928]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [[0.0, 0.0, 1.0], [0.121, 0.895, 0.429]]
[[joint]]
type = "prismatic"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[0.121, 0.895, 0.429], [-0.146, 0.913, 0.38]]
turn = -0.457
[[joint]]
type = "revolute"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [[-0.184, -0.402, 0.897], [-0.295, 0.453, 0.841]]
[[joint]]
type = "universal"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[-0.928, 0.291, 0.231], [-0.897, 0.442, 0.008]]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "b5.P9"]
axis = [[-0.897, 0.442, 0.008], [0.334, 0.518, -0.787]]
[[joint]]
type = "revolute"
name = "j5"
at = ["b5.P10", "ground.P11"]
axis = [[0.334, 0.518, -0.787], [0.0, 1.0, 0.0]]
[[driver]]
angle = "j0"
start = 2.214449514592658
)toml"));
  EXPECT_GT(result.counts.fitted, 0U) << result.message;
}

TEST(Fit, TwoClosuresFarFromAFoldDoNotHangTogether) {
  const Mechanism mechanism = four_bar("2", "3", "4", "5", "1", 1e-3);
  const ClosureResult result = closures_of(mechanism);
  ASSERT_EQ(result.closures.size(), 2U) << result.message;
  const Phi phi(mechanism);
  const WithinFit within(phi, 1e-3, 0);
  for (const Closure& closure : result.closures) {
    EXPECT_FALSE(within.is_weak(closure.q));
    EXPECT_LT(*closure.play, 0.01);
  }
  EXPECT_FALSE(within.joins(result.closures[0].q, result.closures[1].q));
  EXPECT_EQ(result.message, "every path was decided");
}

TEST(Fit, HasNoPlayWhereNoFitIsGiven) {
  Mechanism mechanism = four_bar("2", "3", "4", "5", "1", 1e-3);
  mechanism.fit.reset();
  const ClosureResult result = closures_of(mechanism);
  EXPECT_FALSE(result.closures.front().play);
}

// Two crosses and a slip joint: rotation vectors that came to a whole turn ended there, and 45 such
// poses, each beside a closure, were told as closures of their own.
TEST(Fit, IsNotMetAgainWhereARotationVectorIsAWholeTurn) {
  const ClosureResult result = closures_of(mechanism_text(R"toml(
space = "spatial"
fit = 0.0005
[ground.points]
P0 = [-1.0, 0.0, 0.0]
P9 = [4.0, 1.0, 0.0]
[body.b1.points]
P1 = [-1.0, 0.0, 0.0]
P2 = [0.0, 0.0, 0.0]
[body.b2.points]
P3 = [0.0, 0.0, 0.0]
P4 = [0.9487, 0.3162, 0.0]
[body.b3.points]
P5 = [1.8974, 0.6325, 0.0]
P6 = [3.0, 1.0, 0.0]
[body.b4.points]
P7 = [3.0, 1.0, 0.0]
P8 = [4.0, 1.0, 0.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [1.0, 0.0, 0.0]
[[joint]]
type = "universal"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[0.0, -0.8672, 0.498], [-0.1638, 0.4913, 0.8555]]
[[joint]]
type = "prismatic"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [0.9487, 0.3162, 0.0]
turn = 0.0
[[joint]]
type = "universal"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[-0.1638, 0.4913, 0.8555], [0.0, -0.8672, 0.498]]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [1.0, 0.0, 0.0]
[[driver]]
angle = "j0"
start = 0.0
)toml"));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.fitted, 0U);
  EXPECT_EQ(result.closures.size(), 8U);
}

// Of a Sarrus linkage as many equations as unknowns are solved, and these have no roots that are
// poses.
TEST(Fit, FindsASarrusLinkageInFramesOfItsOwn) {
  const Mechanism mechanism = mechanism_text(R"toml(
space = "spatial"
fit = 0.0005
[ground.points]
P0 = [2.0, 0.0, 0.0]
P6 = [0.0, 2.0, 0.0]
[body.b1.points]
P5 = [1.9636, 3.4169, -3.5691]
P11 = [2.9807, 4.2974, -1.0811]
[body.b2.points]
P1 = [0.9184, 1.872, -2.7718]
P2 = [-1.0684, 3.1657, -4.3141]
[body.b3.points]
P3 = [1.0441, 3.3758, 1.8482]
P4 = [1.3066, 2.0633, 4.3399]
[body.b4.points]
P7 = [-0.4773, 0.3614, -1.0652]
P8 = [-2.9307, 0.6621, -2.4401]
[body.b5.points]
P9 = [2.6191, -2.756, -0.0808]
P10 = [1.9019, -3.335, 2.5932]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b2.P1"]
axis = [[0.0, 1.0, 0.0], [-0.2932, -0.8841, -0.3639]]
[[joint]]
type = "revolute"
name = "j1"
at = ["b2.P2", "b3.P3"]
axis = [[-0.2932, -0.8841, -0.3639], [-0.9513, 0.2199, 0.216]]
[[joint]]
type = "revolute"
name = "j2"
at = ["b3.P4", "b1.P5"]
axis = [[-0.9513, 0.2199, 0.216], [0.0765, 0.8849, 0.4594]]
[[joint]]
type = "revolute"
name = "j3"
at = ["ground.P6", "b4.P7"]
axis = [[1.0, 0.0, 0.0], [0.3234, 0.863, -0.3882]]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "b5.P9"]
axis = [[0.3234, 0.863, -0.3882], [-0.3602, -0.8871, -0.2887]]
[[joint]]
type = "revolute"
name = "j5"
at = ["b5.P10", "b1.P11"]
axis = [[-0.3602, -0.8871, -0.2887], [-0.432, 0.4447, -0.7846]]
[[driver]]
angle = "j0"
start = 1.6106854610455656
)toml");
  // Where its bodies were drawn.
  const Eigen::Vector3d drawn(-1.4715, -1.5342, 0.2765);
  const Eigen::Vector3d lower(-1.2459, 0.9157, 0.8099);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    const bool is_there =
        std::any_of(result.closures.begin(), result.closures.end(), [&](const Closure& closure) {
          return (closure.q.segment<3>(0) - drawn).norm() < 5e-3 &&
                 (closure.q.segment<3>(6) - lower).norm() < 5e-3 && *closure.play < 0.05;
        });
    EXPECT_TRUE(is_there) << "seed " << seed << ": " << result.message;
    const bool has_set = std::any_of(result.closures.begin(), result.closures.end(),
                                     [](const Closure& closure) { return *closure.play > 2; });
    EXPECT_TRUE(has_set) << "seed " << seed;
  }
}

// A wheel pinned at its middle: where its teeth stand moves nothing else. The rods meet within fit
// only, and least squares turned the wheel ten teeth on, to where another turn of the crank would
// have it.
TEST(Fit, AWheelStaysInTheDrawnMeshing) {
  const Mechanism mechanism = mechanism_text(R"toml(
fit = 0.0005
[ground.points]
P0 = [-6.0, 0.0]
P2 = [-2.0, 0.0]
P8 = [6.0, 0.0]
[body.b1.points]
P1 = [0.0, 0.0]
P5 = [0.8084, 3.9175]
[body.b2.points]
P3 = [0.0, 0.0]
[body.b3.points]
P4 = [-1.3171, 9.9129]
P6 = [-0.7903, 5.9477]
P7 = [-1.5805, 11.8955]
[[joint]]
type = "revolute"
at = ["ground.P0", "b1.P1"]
[[joint]]
type = "revolute"
at = ["ground.P2", "b2.P3"]
[[joint]]
type = "gear"
bodies = ["b1", "b2"]
ratio = [30, 20]
phase = 0.3315
carrier = "ground"
[[joint]]
type = "rod"
at = ["b3.P4", "b1.P5"]
length = 2.0
[[joint]]
type = "rod"
at = ["b3.P6", "b2.P3"]
length = 2.0
[[joint]]
type = "rod"
at = ["b3.P7", "ground.P8"]
length = 12.0
[[driver]]
angle = "b1"
start = -1.3673
)toml");
  constexpr double kWheel = 1.5 * -1.3673 + 0.3315;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_FALSE(result.closures.empty()) << result.message;
    for (const Closure& closure : result.closures) EXPECT_NEAR(closure.q[5], kWheel, 1e-3);
  }
}

}  // namespace
}  // namespace moivre
