// SPDX-License-Identifier: MIT
// Which bodies turn about a line while everything else stands, and does the row that holds them
// leave one pose of all?
#include "moivre/mechanism/spins.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "files.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::VectorXd;
using test::typed;

Mechanism held(const char* text) {
  Mechanism mechanism = typed(text);
  mechanism.held_spins = find_spins(mechanism);
  return mechanism;
}

TEST(Spins, AreOfABodyThatTwoBallsAloneTieToOthers) {
  const Mechanism mechanism = typed(test::kSpinningCoupler);
  const std::vector<Spin> spins = find_spins(mechanism);
  ASSERT_EQ(spins.size(), 1U);
  EXPECT_EQ(mechanism.bodies[spins[0].body].name, "coupler");
  EXPECT_EQ(spins[0].line[0].body, spins[0].body);
  EXPECT_EQ(spins[0].line[1].body, spins[0].body);
}

TEST(Spins, AreNotOfABodyWithAThirdJointOrADrivenPoint) {
  const std::string text = test::kSpinningCoupler;
  EXPECT_TRUE(find_spins(typed(text + "[[joint]]\ntype = \"point-on-plane\"\nat = [\"ground.O4\", "
                                      "\"coupler.B\"]\naxis = [0, 0, 1]\n"))
                  .empty());
  EXPECT_TRUE(find_spins(typed(text + "[[driver]]\nx = \"coupler.B\"\nstart = 1\n")).empty());
  EXPECT_TRUE(find_spins(test::example("rssr")).empty());
  EXPECT_TRUE(find_spins(test::example("four-bar")).empty());
}

TEST(Spins, HaveOneRowThatTheTurnAloneChanges) {
  const Mechanism mechanism = held(test::kSpinningCoupler);
  const Phi phi(mechanism);
  ASSERT_EQ(phi.size(), Phi(typed(test::kSpinningCoupler)).size() + 1);
  const Eigen::Index row = phi.size() - phi.driver_size() - 1;
  EXPECT_EQ(phi.row_names()[static_cast<std::size_t>(row)], "spin of coupler");
  VectorXd q = VectorXd::Zero(phi.dimension());
  EXPECT_EQ(phi.value(q, 0)[row], 0) << "as drawn";
  // Turned about its line, which is drawn along x, by every angle: the row vanishes at two of them,
  // half a turn apart.
  int changes = 0;
  double before = 0;
  for (int k = 1; k <= 100; ++k) {
    q[9] = 0.0628 * k - 2;
    const double value = phi.value(q, 0)[row];
    changes += before * value < 0 ? 1 : 0;
    before = value;
  }
  EXPECT_EQ(changes, 2);
}

/// A connecting rod between balls, and a piston whose ball stands `off` its axis.
std::string piston(const std::string& off) {
  return R"toml(space = "spatial"
[ground.points]
O = [0, 0, 0]
G = [3, 0, 0]
[body.crank.points]
O = [0, 0, 0]
A = [0, 1, 0]
[body.rod.points]
A = [0, 1, 0]
B = [4, 0, 0]
[body.piston.points]
B = [4, )toml" +
         off + R"toml(, 0]
G = [3, 0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
axis = [0, 0, 1]
name = "crank"
[[joint]]
type = "spherical"
at = ["crank.A", "rod.A"]
[[joint]]
type = "spherical"
at = ["rod.B", "piston.B"]
[[driver]]
angle = "crank"
start = 0.2
[[joint]]
type = "cylindrical"
at = ["ground.G", "piston.G"]
axis = [1, 0, 0]
name = "bore"
)toml";
}

TEST(IdleTurns, AreAboutAnAxisThatAllOtherJointsLetTurn) {
  const Mechanism mechanism = typed(piston("0"));
  const std::vector<IdleTurn> turns = find_idle_turns(mechanism);
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_EQ(mechanism.bodies[turns[0].body].name, "piston");
  EXPECT_EQ(mechanism.joints[turns[0].joint].name, "bore");
}

TEST(IdleTurns, AreNoneWhereAnotherJointOrADriverHoldsThem) {
  EXPECT_TRUE(find_idle_turns(typed(piston("0.1"))).empty()) << "a ball beside the axis";
  EXPECT_TRUE(
      find_idle_turns(typed(piston("0") + "[[driver]]\nangle = \"bore\"\nstart = 0\n")).empty());
  EXPECT_TRUE(
      find_idle_turns(typed(piston("0") + "[[driver]]\nx = \"piston.G\"\nstart = 3\n")).empty());
  EXPECT_TRUE(find_idle_turns(typed(piston("0") + "[[joint]]\ntype = \"prismatic\"\n"
                                                  "at = [\"ground.G\", \"piston.G\"]\n"
                                                  "axis = [1, 0, 0]\n"))
                  .empty());
  EXPECT_TRUE(find_idle_turns(typed(test::kSpinningCoupler)).empty());
  EXPECT_TRUE(find_idle_turns(test::example("slider-crank")).empty());
}

}  // namespace
}  // namespace moivre
