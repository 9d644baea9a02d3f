// SPDX-License-Identifier: MIT
// Do links between two points say no more than a distance, and stand in both their postures?
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mechanisms.h"
#include "moivre/closures/same_pose.h"
#include "moivre/mechanism/phi.h"

namespace moivre {
namespace {

/// A platform on legs 1 to 6 from base to top, drawn as it is assembled; as a rod each leg has the
/// length that is drawn.
std::string on_legs(const std::string& first_leg) {
  return R"toml(space = "spatial"
[ground.points]
A1 = [2, 0.3, 0.1]
A2 = [1.4, 1.5, -0.2]
A3 = [-0.9, 1.8, 0]
A4 = [-2, 0.4, 0.3]
A5 = [-0.8, -1.9, 0.2]
A6 = [1.2, -1.6, -0.1]
[body.platform.points]
B1 = [1.1, 0.6, 2.0]
B2 = [0.2, 1.2, 2.3]
B3 = [-0.4, 1.1, 1.9]
B4 = [-1.2, -0.5, 2.2]
B5 = [-0.3, -0.9, 1.8]
B6 = [0.9, -0.8, 2.1]
)toml" + first_leg +
         R"toml(
[[joint]]
type = "rod"
at = ["ground.A2", "platform.B2"]
length = 2.7892651361962706
[[joint]]
type = "rod"
at = ["ground.A3", "platform.B3"]
length = 2.085665361461421
[[joint]]
type = "rod"
at = ["ground.A4", "platform.B4"]
length = 2.249444375840399
[[joint]]
type = "rod"
at = ["ground.A5", "platform.B5"]
length = 1.9519221295943134
[[joint]]
type = "rod"
at = ["ground.A6", "platform.B6"]
length = 2.3600847442411896
)toml";
}

const char* const kRod = R"toml([[joint]]
type = "rod"
at = ["ground.A1", "platform.B1"]
length = 2.12367605815953
)toml";

/// The same leg as a body with a cross at its foot, whose second axis is not across it, and a ball
/// at its head.
const char* const kStrut = R"toml([body.leg.points]
A1 = [2, 0.3, 0.1]
B1 = [1.1, 0.6, 2.0]
[[joint]]
type = "universal"
at = ["ground.A1", "leg.A1"]
axis = [[0, 1, 0], [1, 0, 0.25]]
[[joint]]
type = "spherical"
at = ["leg.B1", "platform.B1"]
)toml";

/// Turned about: the cross at its head.
const char* const kTurnedStrut = R"toml([body.leg.points]
A1 = [2, 0.3, 0.1]
B1 = [1.1, 0.6, 2.0]
[[joint]]
type = "spherical"
at = ["ground.A1", "leg.A1"]
[[joint]]
type = "universal"
at = ["leg.B1", "platform.B1"]
axis = [[1, 0, 0.25], [0, 1, 0]]
)toml";

/// Where the platform, the first body, is in every closure.
std::vector<double> places(const ClosureResult& result) {
  std::vector<double> of_platform;
  for (const Closure& closure : result.closures) {
    of_platform.push_back(closure.q.head<6>().dot(Eigen::VectorXd::LinSpaced(6, 1, 2)));
  }
  std::sort(of_platform.begin(), of_platform.end());
  return of_platform;
}

TEST(Struts, LeaveAPlatformItsFortyPosesAndStandTwoWaysInEach) {
  const ClosureResult on_rods = closures_of(mechanism_text(on_legs(kRod)));
  ASSERT_EQ(on_rods.counts.complex, 40U);
  const std::vector<double> known = places(on_rods);
  for (const char* leg : {kStrut, kTurnedStrut}) {
    const Mechanism mechanism = mechanism_text(on_legs(leg));
    const ClosureResult result = closures_of(mechanism);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 80U);
    EXPECT_EQ(result.completeness, RootCompleteness::proved);
    EXPECT_EQ(result.stages.at(0).paths.tracked, 40U);
    const std::vector<double> found = places(result);
    ASSERT_EQ(found.size(), 2 * known.size());
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], known[k / 2], 1e-9);
    // The drawn pose, q = 0, is one of them.
    const Phi phi(mechanism);
    const Eigen::VectorXd drawn = Eigen::VectorXd::Zero(phi.dimension());
    EXPECT_TRUE(std::any_of(
        result.closures.begin(), result.closures.end(),
        [&](const Closure& closure) { return distance(phi, closure.q, drawn) < 1e-9; }));
  }
}

// Walter, Husty and Pfurner count 78 poses; each of the three legs may be turned by half a turn.
TEST(Struts, OfTheSnuPlatformStandEightWaysInItsSeventyEightPoses) {
  const Mechanism mechanism = mechanism_file("snu-3-upu");
  for (const std::uint64_t seed : {1U, 2U}) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 8 * 78U);
    EXPECT_EQ(result.counts.rejected, 0U);
    EXPECT_EQ(result.closures.size(), 32U);
    for (const Closure& closure : result.closures) EXPECT_LE(closure.residual, 1e-12);
    // Above 78 poses stand 1 + 2 + 4 solves of legs, and each leg is turned once.
    const LeftOut shared{"following the paths of 312 solves",
                         "above roots with the same values they are those of another one"};
    EXPECT_TRUE(std::any_of(
        result.left_out.begin(), result.left_out.end(),
        [&](const LeftOut& one) { return one.what == shared.what && one.why == shared.why; }));
  }
}

// Where a leg lies along its cross's first axis, its place says nothing of that axis's turn: the
// other cross does.
TEST(Struts, AlongTheirFirstAxisStandByTheirOtherCross) {
  const std::string bodies = R"toml(space = "spatial"
[ground.points]
O = [0, 0, 1]
A = [1, 0, 0]
C = [0.3, 1.2, 0]
[body.platform.points]
O = [0, 0, 1]
B = [1.2, 0, 0.9]
D = [0.2, 0.9, 1.3]
[body.leg.points]
A = [1, 0, 0]
B = [1.2, 0, 0.9]
[[joint]]
type = "spherical"
at = ["ground.O", "platform.O"]
[[joint]]
type = "rod"
at = ["ground.C", "platform.D"]
length = 1.3379088160258652
)toml";
  const std::string along = R"toml([[joint]]
type = "universal"
at = ["ground.A", "leg.A"]
axis = [[0.2, 0, 0.9], [0, 1, 0]]
)toml";
  const std::string across = R"toml([[joint]]
type = "universal"
at = ["leg.B", "platform.B"]
axis = [[0, 1, 0], [1, 0, 0.4]]
)toml";
  for (const std::string& legs : {along + across, across + along}) {
    const Mechanism mechanism = mechanism_text(bodies + legs);
    const ClosureResult result = closures_of(mechanism);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, 16U);
    const Phi phi(mechanism);
    const Eigen::VectorXd drawn = Eigen::VectorXd::Zero(phi.dimension());
    EXPECT_TRUE(std::any_of(
        result.closures.begin(), result.closures.end(),
        [&](const Closure& closure) { return distance(phi, closure.q, drawn) < 1e-9; }));
  }
}

// What a ball's fourth equation says follows from the other three on Study's quadric. It must not
// stand for the rod's.
TEST(Struts, ARodTypedLastHidesNoClosure) {
  const std::string bodies = R"toml(space = "spatial"
[ground.points]
P0 = [-1.673, 0.975, 1.894]
P1 = [-0.366, -1.182, 0.216]
P2 = [-1.802, 0.753, -0.185]
[body.top.points]
P0 = [-0.44, 1.464, 0.783]
P1 = [1.62, -0.741, -0.265]
P2 = [-1.802, 0.753, -0.185]
[body.leg.points]
P0 = [-0.366, -1.182, 0.216]
P1 = [1.62, -0.741, -0.265]
)toml";
  const std::string rod = R"toml([[joint]]
type = "rod"
at = ["ground.P0", "top.P0"]
length = 1.7302401567412542
)toml";
  const std::string others = R"toml([[joint]]
type = "spherical"
at = ["ground.P1", "leg.P0"]
[[joint]]
type = "revolute"
at = ["leg.P1", "top.P1"]
axis = [-0.46, -0.57, -0.67]
[[joint]]
type = "spherical"
at = ["ground.P2", "top.P2"]
)toml";
  const ClosureResult first = closures_of(mechanism_text(bodies + rod + others));
  const ClosureResult last = closures_of(mechanism_text(bodies + others + rod));
  EXPECT_TRUE(last.complete) << last.message;
  EXPECT_GE(last.closures.size(), 1U);
  EXPECT_EQ(last.counts.complex, first.counts.complex);
  EXPECT_EQ(last.closures.size(), first.closures.size());
}

}  // namespace
}  // namespace moivre
