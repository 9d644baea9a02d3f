// SPDX-License-Identifier: MIT
// Is what a loop of fractions is, as typed, told exactly: a dead point, a set, a slide along a
// hinge's axis? Rounding of its frames would part the dead point's roots, and leave of a set that
// rounding breaks paths that no digits decide.
#include <gtest/gtest.h>

#include <algorithm>

#include "mechanisms.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

ClosureResult by_lanes(const char* text) {
  ClosureOptions options;
  options.solve.threads = 1;
  return find_closures(mechanism_text(text), *make_lane_tracker(), options);
}

/// Drawn flat, four roots in one: paths to half angles of tangent i beside it were in doubt, and
/// the drawn pose was not listed.
TEST(ExactLoops, AFlatLoopHasItsDrawnPose) {
  const ClosureResult result = by_lanes(R"toml(
space = "spatial"
[ground.points]
P0 = [-3.0, 0.0, 0.0]
P11 = [1.0, 0.0, 0.0]
[body.b1.points]
P1 = [-3.0, 0.0, 0.0]
P2 = [1.0, 0.0, 0.0]
[body.b2.points]
P3 = [1.0, 0.3, 0.4]
P4 = [-2.0, 0.0, 0.0]
[body.b3.points]
P5 = [-2.0, 0.0, 0.0]
P6 = [-3.0, 0.0, 0.0]
[body.b4.points]
P7 = [-3.0, 0.0, 0.5]
P8 = [0.0, 0.0, 0.0]
[body.b5.points]
P9 = [0.0, 0.0, 0.0]
P10 = [1.0, 0.0, 0.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [0.0, 0.0, 1.0]
[[joint]]
type = "prismatic"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [0.0, 0.6, 0.8]
turn = 0.0
[[joint]]
type = "revolute"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [0.0, 0.6, 0.8]
[[joint]]
type = "cylindrical"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [0.0, 0.0, 1.0]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "b5.P9"]
axis = [0.0, 1.0, 0.0]
[[joint]]
type = "revolute"
name = "j5"
at = ["b5.P10", "ground.P11"]
axis = [0.0, 0.6, 0.8]
[[driver]]
angle = "j0"
start = 0.0
)toml");
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.closures.size(), 1U);
  EXPECT_TRUE(result.closures[0].is_drawn);
  EXPECT_EQ(result.closures[0].multiplicity, 4U);
}

/// A slide moves along the axis of the hinge beside it: of eight roots four are no poses.
TEST(ExactLoops, ASlideAlongAHingesAxis) {
  const ClosureResult result = by_lanes(R"toml(
space = "spatial"
[ground.points]
P0 = [6.0, -4.0, -2.0]
P9 = [-4.0, -2.0, 4.0]
[body.b1.points]
P1 = [6.0, -4.0, -2.0]
P2 = [6.0, 4.0, 2.0]
[body.b2.points]
P3 = [6.0, 4.6, 2.8]
P4 = [4.0, -6.0, 0.0]
[body.b3.points]
P5 = [4.0, -5.0, 0.0]
P6 = [4.0, -4.0, -2.0]
[body.b4.points]
P7 = [4.0, -4.0, -2.0]
P8 = [-4.0, -2.0, 4.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [0.0, 0.0, 1.0]
[[joint]]
type = "cylindrical"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [0.0, 0.6, 0.8]
[[joint]]
type = "prismatic"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [0.0, 1.0, 0.0]
turn = 0.0
[[joint]]
type = "universal"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[0.6, 0.0, 0.8], [0.0, 1.0, 0.0]]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [0.0, 0.6, 0.8]
[[driver]]
angle = "j0"
start = 0.0
)toml");
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_EQ(result.counts.complex, 4U);
  EXPECT_EQ(result.counts.real, 4U);
  EXPECT_EQ(result.paths.multiprecision, 0U);
}

/// Slides of a cylindrical and a prismatic joint go along one direction, seen from frames that are
/// turned otherwise about it. Rounded apart they would have roots at slides of 1e13.
TEST(ExactLoops, ParallelSlidesInTurnedFramesStayParallel) {
  const ClosureResult result = by_lanes(R"toml(
space = "spatial"
[ground.points]
P0 = [6.0, 2.0, 4.0]
P9 = [3.0, -4.0, 0.0]
[body.b1.points]
P1 = [-1.83, -4.66, 7.64]
P2 = [3.68, 4.81, 7.52]
[body.b2.points]
P3 = [9.64, 2.43, 0.91]
P4 = [-4.15, -0.88, 4.23]
[body.b3.points]
P5 = [1.92, 4.99, -2.98]
P6 = [-5.76, 5.06, 0.0]
[body.b4.points]
P7 = [-6.3, 1.21, 1.14]
P8 = [3.66, -1.74, 4.16]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [[0.6, 0.0, 0.8], [-0.52, -0.15, 0.84]]
[[joint]]
type = "revolute"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [[-0.29, -0.88, 0.37], [-0.3, -0.27, -0.91]]
[[joint]]
type = "universal"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [[0.91, -0.36, -0.19], [0.72, -0.46, 0.52]]
[[joint]]
type = "cylindrical"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[0.72, -0.46, 0.52], [0.85, -0.03, -0.52]]
[[joint]]
type = "prismatic"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [[0.85, -0.03, -0.52], [1.0, 0.0, 0.0]]
turn = -0.98
[[driver]]
angle = "j0"
start = 1.6401361500056963
)toml");
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_TRUE(result.closures.empty());
  EXPECT_EQ(result.paths.multiprecision, 0U);
}

/// A link spins between two hinges on one line.
TEST(ExactLoops, ALinkThatSpinsIsASet) {
  const ClosureResult result = by_lanes(R"toml(
space = "spatial"
[ground.points]
P0 = [40.0, 0.0, 0.0]
P11 = [-60.0, 0.0, 0.0]
[body.b1.points]
P1 = [40.0, 0.0, 0.0]
P2 = [0.0, 0.0, 0.0]
[body.b2.points]
P3 = [6.0, 0.0, 8.0]
P4 = [40.0, 0.0, 0.0]
[body.b3.points]
P5 = [40.0, 0.0, 0.0]
P6 = [-40.0, 0.0, 0.0]
[body.b4.points]
P7 = [-40.0, 0.0, 0.0]
P8 = [-20.0, 0.0, 0.0]
[body.b5.points]
P9 = [-14.0, 0.0, 8.0]
P10 = [-60.0, 0.0, 0.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [0.0, 1.0, 0.0]
[[joint]]
type = "prismatic"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [0.6, 0.0, 0.8]
turn = 0.0
[[joint]]
type = "revolute"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [1.0, 0.0, 0.0]
[[joint]]
type = "universal"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
[[joint]]
type = "prismatic"
name = "j4"
at = ["b4.P8", "b5.P9"]
axis = [0.6, 0.0, 0.8]
turn = 0.0
[[joint]]
type = "revolute"
name = "j5"
at = ["b5.P10", "ground.P11"]
axis = [0.0, 0.6, 0.8]
[[driver]]
angle = "j0"
start = 0.0
)toml");
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_TRUE(result.moves);
}

/// Drawn at a dead point of the second block, above roots of the first that are known to double:
/// its double root was parted into two complex ones.
TEST(ExactLoops, ADeadPointAboveRootsThatAreRounded) {
  const ClosureResult result = by_lanes(R"toml(
space = "spatial"
[ground.points]
P0 = [8.0, -12.0, -12.0]
P9 = [8.0, 8.0, -2.0]
[body.b1.points]
P1 = [8.0, -12.0, -12.0]
P2 = [-4.0, 0.0, -8.0]
[body.b2.points]
P3 = [-4.0, 0.0, -8.0]
P4 = [4.0, -8.0, -8.0]
[body.b3.points]
P5 = [4.0, -6.0, -8.0]
P6 = [-8.0, -12.0, -4.0]
[body.b4.points]
P7 = [-8.0, -12.0, -4.0]
P8 = [8.0, 8.0, -4.0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.P0", "b1.P1"]
axis = [0.0, 0.0, 1.0]
[[joint]]
type = "revolute"
name = "j1"
at = ["b1.P2", "b2.P3"]
axis = [0.0, 1.0, 0.0]
[[joint]]
type = "cylindrical"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [0.0, 1.0, 0.0]
[[joint]]
type = "revolute"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [0.6, 0.0, 0.8]
[[joint]]
type = "cylindrical"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [0.0, 0.0, 1.0]
[[driver]]
angle = "j0"
start = 0.0
)toml");
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_EQ(result.closures.size(), 1U) << result.message;
  EXPECT_TRUE(result.closures[0].is_drawn);
  EXPECT_EQ(result.closures[0].multiplicity, 2U);
}

}  // namespace
}  // namespace moivre
