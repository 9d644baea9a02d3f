// SPDX-License-Identifier: MIT
// Is what rounded numbers make of a loop's special geometry told for what it is: slides along
// parallel lines, a set that is there, several roots that are one?
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mechanisms.h"
#include "moivre/certify/certifier.h"
#include "moivre/mechanism/read.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

/// Two slides go along the z axis, exactly; the other numbers have three decimals. What the loop
/// lacks across that axis no slide makes up.
constexpr const char* kParallelSlides = R"toml(
space = "spatial"
[ground.points]
P0 = [4.0, -8.0, 4.0]
P11 = [12.0, 4.0, -10.0]
[body.b1.points]
P1 = [7.1, 4.91, -3.503]
P2 = [0.512, 5.95, 0.916]
[body.b2.points]
P3 = [6.342, 3.395, -0.333]
P4 = [-12.924, 1.36, -5.686]
[body.b3.points]
P5 = [5.221, 11.677, 1.066]
P6 = [-5.622, 0.501, -13.817]
[body.b4.points]
P7 = [4.243, 5.566, -11.962]
P8 = [4.793, -10.027, 6.384]
[body.b5.points]
P9 = [9.934, 2.95, 7.611]
P10 = [18.114, -6.383, 0.265]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [[0.0, 0.0, 1.0], [0.494, 0.642, 0.586]]
[[joint]]
type = "prismatic"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[0.494, 0.642, 0.586], [0.865, -0.336, -0.372]]
turn = 1.433
[[joint]]
type = "revolute"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [[0.865, -0.336, -0.372], [0.432, -0.881, -0.19]]
[[joint]]
type = "cylindrical"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[-0.55, -0.425, 0.719], [0.379, -0.903, 0.202]]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "b5.P9"]
axis = [[0.392, -0.041, -0.919], [0.37, 0.184, -0.911]]
[[joint]]
type = "prismatic"
name = "j5"
at = ["b5.P10", "ground.P11"]
axis = [[-0.435, 0.9, 0.005], [0.0, 0.0, 1.0]]
turn = 1.145
[[driver]]
angle = "j0"
start = -1.8969126627533575)toml";

/// A slide goes along the axis of a cylindrical joint beside it, which leaves five freedoms.
constexpr const char* kSlideAlongCylinder = R"toml(space = "spatial"
[ground.points]
P0 = [-4.0, 0.0, 0.0]
P9 = [3.0, 0.0, 0.0]
[body.b1.points]
P1 = [-2.826, -1.744, 2.931]
P2 = [-1.388, -1.085, 1.708]
[body.b2.points]
P3 = [-1.577, 1.059, 0.395]
P4 = [5.231, 4.448, 2.879]
[body.b3.points]
P5 = [1.055, 4.433, 5.692]
P6 = [2.673, -1.996, -1.794]
[body.b4.points]
P7 = [-1.299, 1.474, -0.647]
P8 = [1.332, -2.69, -1.507]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [[0.0, 0.6, 0.8], [-0.178, 0.938, 0.297]]
[[joint]]
type = "universal"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[0.64, 0.748, 0.175], [-0.477, 0.871, 0.119]]
[[joint]]
type = "revolute"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [[-0.477, 0.871, 0.119], [0.939, 0.333, -0.083]]
[[joint]]
type = "prismatic"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[-0.162, 0.643, 0.749], [0.526, -0.833, -0.172]]
turn = 2.058
[[joint]]
type = "cylindrical"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [[0.526, -0.833, -0.172], [1.0, 0.0, 0.0]]
[[driver]]
angle = "j0"
start = -0.7512682368850889)toml";

void expect_misses_by_little(const char* text) {
  Mechanism mechanism = mechanism_text(text);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 0U);
    EXPECT_FALSE(result.moves);
    EXPECT_TRUE(result.message.starts_with("cannot be assembled: there is no closure"))
        << result.message;
    ASSERT_TRUE(result.least_misfit);
    EXPECT_LE(*result.least_misfit, 5e-3);
  }
  mechanism.fit = 5e-3;
  const ClosureResult fitted = closures_of(mechanism);
  EXPECT_TRUE(fitted.complete) << fitted.message;
  EXPECT_GE(fitted.counts.fitted, 1U);
}

// The rounded equations have a root at 1e13 lengths, which is on no set.
TEST(RoundedLoops, ParallelSlidesThatMissAreNoSet) { expect_misses_by_little(kParallelSlides); }

TEST(RoundedLoops, ASlideAlongACylindersAxisMakesUpNoMoreThanTheCylinder) {
  expect_misses_by_little(kSlideAlongCylinder);
}

/// Three parallel hinges and a slide across them move in their plane, with the other axes at rest.
TEST(RoundedLoops, ALoopThatMovesInAPlaneDoesSoBehindAxesThatAreNoFractions) {
  const Mechanism mechanism = mechanism_text(R"toml(space = "spatial"
[ground.points]
P0 = [0.0, -8.0, -12.0]
P9 = [8.0, 4.0, -8.0]
[body.b1.points]
P1 = [0.0, -8.0, -12.0]
P2 = [4.0, 8.0, -8.0]
[body.b2.points]
P3 = [4.0, 8.0, -8.0]
P4 = [8.0, 12.0, 12.0]
[body.b3.points]
P5 = [8.0, 12.0, 12.0]
P6 = [-8.0, -4.0, 8.0]
[body.b4.points]
P7 = [-8.0, -2.8, 9.6]
P8 = [8.0, 4.0, -8.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [0.6, 0.0, 0.8]
[[joint]]
type = "universal"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
[[joint]]
type = "universal"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]
[[joint]]
type = "prismatic"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [0.0, 0.6, 0.8]
turn = 0.0
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [1.0, 0.0, 0.0]
[[driver]]
angle = "j0"
start = 0.0)toml");
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_TRUE(result.moves) << result.message;
    EXPECT_EQ(result.moves->dimension, 1U);
  }
}

/// Both slots stand across their arms, the one that turns the other's: what a direction of length 1
/// parts by 1e-8 is parted by 1e-4 above.
TEST(RoundedLoops, ADeadPointAboveADeadPointIsOneCluster) {
  const Mechanism mechanism = mechanism_text(R"toml([ground.points]
P0 = [4.0, 0.0]
P2 = [6.0, 6.0]
P4 = [-2.0, 4.0]
[body.b1.points]
P1 = [4.0, 0.0]
P7 = [4.0, 6.0]
[body.b2.points]
P3 = [6.0, 6.0]
P8 = [2.0, 2.0]
[body.b3.points]
P5 = [-2.0, 4.0]
P6 = [6.0, 0.0]
P11 = [4.0, 6.0]
[body.b4.points]
P9 = [2.0, 2.0]
P10 = [8.0, 4.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
[[joint]]
type = "revolute"
name = "j1"
at = ["ground.P2", "b2.P3"]
[[joint]]
type = "gear"
name = "j2"
bodies = ["b1", "b2"]
ratio = [-1, 1]
phase = 0.0
carrier = "ground"
[[joint]]
type = "revolute"
name = "j3"
at = ["ground.P4", "b3.P5"]
[[joint]]
type = "slot"
name = "j4"
at = ["b3.P6", "b1.P7"]
along = [-2.0, 6.0]
[[joint]]
type = "revolute"
name = "j5"
at = ["b2.P8", "b4.P9"]
[[joint]]
type = "slot"
name = "j6"
at = ["b4.P10", "b3.P11"]
along = [-4.0, 2.0]
[[driver]]
angle = "b1"
start = 0.0)toml");
  for (const auto& tracker : {make_cvode_tracker(), make_lane_tracker()}) {
    const ClosureResult result = find_closures(mechanism, *tracker);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_EQ(result.closures.size(), 1U);
    EXPECT_TRUE(result.closures.front().is_drawn);
    EXPECT_EQ(result.closures.front().multiplicity, 4U);
    EXPECT_TRUE(result.closures.front().cluster);
  }
}

/// A dyad's two bars are in line with its ends, whatever the bodies before do: every closure is a
/// double one, complex ones too, of which rounding parts some and not their images.
TEST(RoundedLoops, OfComplexDoubleClosuresNoImageIsMissing) {
  const Mechanism mechanism = mechanism_text(R"toml([ground.points]
P0 = [0.0, 6.0]
P9 = [-4.0, 2.0]
P13 = [-6.0, 0.0]
P17 = [4.0, 2.0]
P19 = [-4.0, -4.0]
[body.b1.points]
P1 = [0.0, 6.0]
P5 = [-6.0, -6.0]
[body.b2.points]
P2 = [-2.0, -2.0]
P6 = [2.0, 6.0]
P10 = [0.0, 2.0]
[body.b3.points]
P3 = [-2.0, -2.0]
P4 = [-6.0, -6.0]
[body.b4.points]
P7 = [2.0, 6.0]
P8 = [-4.0, 2.0]
P20 = [0.0, -4.0]
[body.b5.points]
P11 = [0.0, 2.0]
P12 = [-6.0, 0.0]
P15 = [2.0, -2.0]
[body.b6.points]
P14 = [2.0, 6.0]
P16 = [-2.0, 2.0]
P18 = [4.0, -2.0]
[body.b7.points]
P21 = [0.0, -4.0]
P22 = [1.0, 1.0]
[body.b8.points]
P23 = [1.0, 1.0]
P24 = [2.0, 6.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
[[joint]]
type = "revolute"
name = "j1"
at = ["b2.P2", "b3.P3"]
[[joint]]
type = "revolute"
name = "j2"
at = ["b3.P4", "b1.P5"]
[[joint]]
type = "revolute"
name = "j3"
at = ["b2.P6", "b4.P7"]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "ground.P9"]
[[joint]]
type = "revolute"
name = "j5"
at = ["b2.P10", "b5.P11"]
[[joint]]
type = "revolute"
name = "j6"
at = ["b5.P12", "ground.P13"]
[[joint]]
type = "rod"
name = "j7"
at = ["b6.P14", "b5.P15"]
length = 8.0
[[joint]]
type = "rod"
name = "j8"
at = ["b6.P16", "ground.P17"]
length = 6.0
[[joint]]
type = "rod"
name = "j9"
at = ["b6.P18", "ground.P19"]
length = 8.25
[[joint]]
type = "revolute"
name = "j10"
at = ["b4.P20", "b7.P21"]
[[joint]]
type = "revolute"
name = "j11"
at = ["b7.P22", "b8.P23"]
[[joint]]
type = "revolute"
name = "j12"
at = ["b8.P24", "b2.P6"]
[[driver]]
angle = "b1"
start = 0.0)toml");
  const ClosureResult result = find_closures(mechanism, *make_lane_tracker());
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.real, 10U);
  EXPECT_EQ(result.counts.complex, 36U);
}

/// Three roots of a dead point, which rounding parts by 1e-7.
TEST(RoundedLoops, ThreeClosuresThatAreOneAreNoSet) {
  const std::string fractions = R"toml(
space = "spatial"
[ground.points]
P0 = [-4.0, -6.0, 2.0]
P9 = [2.0, -6.0, 0.0]
[body.b1.points]
P1 = [-4.0, -6.0, 2.0]
P2 = [-6.0, -6.0, 2.0]
[body.b2.points]
P3 = [-6.0, -6.0, 2.0]
P4 = [4.0, -6.0, 0.0]
[body.b3.points]
P5 = [4.0, -6.0, 0.0]
P6 = [4.0, -2.0, -4.0]
[body.b4.points]
P7 = [4.0, -2.0, -4.0]
P8 = [2.0, -6.0, 0.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [0.0, 0.0, 1.0]
[[joint]]
type = "universal"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[0.6, 0.0, 0.8], [0.0, 1.0, 0.0]]
[[joint]]
type = "universal"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [[0.6, 0.0, 0.8], [0.0, 1.0, 0.0]]
[[joint]]
type = "revolute"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [0.0, 1.0, 0.0]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [0.6, 0.0, 0.8]
[[driver]]
angle = "j0"
start = 0.0)toml";
  for (const bool is_rounded : {false, true}) {
    const ClosureResult result = closures_of(mechanism_text(
        is_rounded
            ? replaced(fractions, "0.6, 0.0, 0.8]", "0.7071067811865476, 0.0, 0.7071067811865476]")
            : fractions));
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_EQ(result.counts.real, 6U);
    const auto drawn = std::find_if(result.closures.begin(), result.closures.end(),
                                    [](const Closure& closure) { return closure.is_drawn; });
    ASSERT_NE(drawn, result.closures.end());
    EXPECT_EQ(drawn->cluster, is_rounded || !proves_beyond_double());
    EXPECT_EQ(drawn->multiplicity, 3U);
  }
}

/// Flat but for rounding: eight paths go to half angles of tangent i, and no digits tell which.
TEST(RoundedLoops, NoMoreThanSixteenClosuresAreLookedFor) {
  if (!proves_beyond_double()) GTEST_SKIP() << "needs more digits";
  const Mechanism mechanism = mechanism_text(R"toml(
space = "spatial"
[ground.points]
P0 = [0.0, 0.0, 0.0]
P11 = [6.0, 0.0, 0.0]
[body.b1.points]
P1 = [-2.047, 1.348, 0.361]
P2 = [-0.165, 6.443, -2.188]
[body.b2.points]
P3 = [0.409, 0.1, 5.575]
P4 = [-2.346, 2.568, -3.716]
[body.b3.points]
P5 = [-4.344, -2.273, -0.145]
P6 = [-6.221, -2.865, 0.208]
[body.b4.points]
P7 = [2.329, 4.668, 2.024]
P8 = [-0.914, -2.801, -1.81]
[body.b5.points]
P9 = [1.994, -3.802, 0.11]
P10 = [2.391, -5.717, 0.53]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [[0.0, 0.6, 0.8], [0.542, 0.207, 0.814]]
[[joint]]
type = "revolute"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[0.909, 0.409, 0.076], [-0.176, 0.52, 0.836]]
[[joint]]
type = "universal"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [[0.275, -0.247, 0.929], [-0.166, -0.06, -0.984]]
[[joint]]
type = "prismatic"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[0.939, 0.296, -0.177], [-0.36, -0.83, -0.426]]
turn = 0.833
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "b5.P9"]
axis = [[-0.623, -0.126, 0.772], [-0.066, 0.2, 0.977]]
[[joint]]
type = "revolute"
name = "j5"
at = ["b5.P10", "ground.P11"]
axis = [[-0.663, -0.741, 0.107], [0.6, 0.0, 0.8]]
[[driver]]
angle = "j0"
start = 0.5196159424088633)toml");
  const ClosureResult result = closures_of(mechanism);
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 16U);
  EXPECT_EQ(result.paths.failed, 0U);
  EXPECT_EQ(result.paths.not_needed, 8U);
  EXPECT_EQ(result.completeness, RootCompleteness::proved);
}

/// Hinges in pairs that are parallel, with three decimals: two angles for a turn of three
/// freedoms.
TEST(RoundedLoops, TurnsAboutTwoDirectionsDoNotMakeUpAnyTurn) {
  const Mechanism mechanism = mechanism_text(R"toml(
space = "spatial"
[ground.points]
P0 = [1.0, -1.0, -3.0]
P11 = [-3.0, 0.0, 2.5]
[body.b1.points]
P1 = [1.847, -1.664, -1.052]
P2 = [2.219, 0.682, 1.035]
[body.b2.points]
P3 = [1.352, -0.722, -0.537]
P4 = [0.284, 3.35, -2.349]
[body.b3.points]
P5 = [-2.218, -3.983, 0.223]
P6 = [-3.658, 0.096, -2.476]
[body.b4.points]
P7 = [1.736, -2.503, 0.45]
P8 = [2.574, -1.265, -1.554]
[body.b5.points]
P9 = [-0.469, 1.275, 0.943]
P10 = [-0.827, -2.021, 3.393]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [[0.6, 0.0, 0.8], [0.728, 0.437, 0.528]]
[[joint]]
type = "revolute"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[0.186, 0.493, 0.85], [0.108, 0.789, 0.605]]
[[joint]]
type = "revolute"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [[0.108, 0.789, 0.605], [-0.031, -0.951, -0.309]]
[[joint]]
type = "prismatic"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[0.99, 0.013, -0.139], [-0.551, 0.479, -0.683]]
turn = 2.186
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "b5.P9"]
axis = [[0.832, 0.26, -0.49], [-0.967, -0.247, -0.066]]
[[joint]]
type = "cylindrical"
name = "j5"
at = ["b5.P10", "ground.P11"]
axis = [[-0.967, -0.247, -0.066], [0.0, 0.0, 1.0]]
[[driver]]
angle = "j0"
start = 0.268692466846703)toml");
  const ClosureResult result = closures_of(mechanism);
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 0U);
  EXPECT_NE(result.message.find("turns about two directions at most"), std::string::npos)
      << result.message;
}

// With some seeds one or two of 584 paths have no end in double-double, nor in 300 digits. Exact
// algebra, which costs less than those digits, counts the plate's 208 roots.
TEST(RoundedLoops, OfADeltaWithAPlateInTwoHalvesAreDecidedThoughAPathHasNoEnd) {
  const Mechanism delta = read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/tests/closures/four-legged-delta.toml"));
  const ClosureResult result = find_closures(delta, *make_lane_tracker());
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.stages.front().paths.finite, 208U);
  EXPECT_EQ(result.counts.real, 16U);
}

}  // namespace
}  // namespace moivre
