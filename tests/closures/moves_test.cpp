// SPDX-License-Identifier: MIT
// Is a mechanism that moves told from one that stands, whatever Gruebler's count says of either?
#include <gtest/gtest.h>

#include <algorithm>

#include "mechanisms.h"
#include "moivre/mechanism/phi.h"

namespace moivre {
namespace {

constexpr std::uint64_t kRandomSeeds = 5;

Mechanism undriven(const std::string& file) {
  Mechanism mechanism = mechanism_file(file);
  mechanism.drivers.clear();
  return mechanism;
}

void expect_moves(const Mechanism& mechanism, std::uint64_t dimension) {
  for (std::uint64_t seed = 1; seed <= kRandomSeeds; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    ASSERT_TRUE(result.moves) << "seed " << seed << ": " << result.message;
    EXPECT_EQ(result.moves->dimension, dimension) << "seed " << seed;
    EXPECT_LE(scaled_residual(Phi(mechanism), result.moves->pose, 0), 1e-12);
  }
}

/// Three bodies turn as one about an axis that two of the joints share. Of the polynomials double
/// roots are left, at the same pose for every seed, which look isolated for some.
TEST(Moves, ASetIsNotTakenForDoubleClosures) {
  const Mechanism mechanism = mechanism_text(R"toml(space = "spatial"
[ground.points]
P0 = [0.0, 0.0, 0.0]
P9 = [-8.0, 0.0, 0.0]
[body.b1.points]
P1 = [0.0, 0.0, 0.0]
P2 = [-8.0, 0.0, 0.0]
[body.b2.points]
P3 = [-8.0, 0.0, 0.0]
P4 = [-12.0, 0.0, 0.0]
[body.b3.points]
P5 = [-10.8, 0.0, 1.6]
P6 = [8.0, 0.0, 0.0]
[body.b4.points]
P7 = [8.0, 0.0, 0.0]
P8 = [-8.0, 0.0, 0.0]
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
type = "cylindrical"
name = "j2"
at = ["b2.P4", "b3.P5"]
axis = [0.6, 0.0, 0.8]
[[joint]]
type = "revolute"
name = "j3"
at = ["b3.P6", "b4.P7"]
axis = [0.0, 0.0, 1.0]
[[joint]]
type = "revolute"
name = "j4"
at = ["b4.P8", "ground.P9"]
axis = [0.0, 1.0, 0.0]
[[driver]]
angle = "j0"
start = 0.0)toml");
  for (const std::uint64_t seed : {1U, 2U, 9U}) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.moves) << "seed " << seed << ": " << result.message;
    EXPECT_EQ(result.completeness.value_or(RootCompleteness::open), RootCompleteness::open);
  }
}

/// A slot stands across the arm that turns it: two roots of the first dyad are one, which its
/// direction of length 1 parts by 1e-8. Between them, where it was drawn, the lines of two slides
/// are one, and the bodies of the second dyad go along it.
TEST(Moves, ADoubleRootAtWhichLinesAreOneIsAPlaceOfASet) {
  const Mechanism mechanism = mechanism_text(R"toml(
[ground.points]
P0 = [2, -6]
P2 = [6, -6]
P9 = [-3, 5]
[body.b1.points]
P1 = [2, -6]
P5 = [-4, 2]
[body.b2.points]
P3 = [6, -6]
P4 = [4, 12]
P8 = [-3, 5]
[body.b3.points]
P6 = [-2, 6]
[body.b4.points]
P7 = [-2, 6]
[[joint]]
type = "revolute"
at = ["ground.P0", "b1.P1"]
[[joint]]
type = "revolute"
at = ["ground.P2", "b2.P3"]
[[joint]]
type = "slot"
at = ["b2.P4", "b1.P5"]
along = [-8, -10]
[[joint]]
type = "revolute"
at = ["b3.P6", "b4.P7"]
[[joint]]
type = "prismatic"
at = ["b2.P8", "b3.P6"]
along = [1, 1]
[[joint]]
type = "prismatic"
at = ["ground.P9", "b4.P7"]
along = [1, 1]
[[driver]]
angle = "b1"
start = 0
)toml");
  expect_moves(mechanism, 1);
  EXPECT_TRUE(closures_of(mechanism).closures.empty());
}

/// The triangle, with a link of length 1 that dangles from its tip.
Mechanism triangle_with_a_tail(const std::string& base) {
  return mechanism_text(test::triangle_text(base) + R"toml(
[body.tail.points]
A = [0, 0]
T = [1, 0]
[[joint]]
type = "revolute"
at = ["left.A", "tail.A"]
)toml");
}

TEST(Moves, AFourBarWithoutDriver) {
  expect_moves(undriven("four-bar"), 1);
  EXPECT_EQ(closures_of(undriven("four-bar")).counts.complex, 0u);
}

TEST(Moves, AFiveBarWithOneDriverOfTwo) {
  Mechanism mechanism = mechanism_file("five-bar");
  mechanism.drivers.pop_back();
  expect_moves(mechanism, 1);
}

TEST(Moves, AFiveBarWithoutDriversInTwoDirections) { expect_moves(undriven("five-bar"), 2); }

TEST(Moves, AThirdParallelCrankThoughEquationsAreAsManyAsUnknowns) {
  const Mechanism mechanism = undriven("double-parallel-crank");
  const Phi phi(mechanism);
  ASSERT_EQ(phi.size(), phi.dimension());
  expect_moves(mechanism, 1);
}

// Where its cranks lie in line motions cross, and some paths end there: no root of them is
// isolated.
TEST(Moves, AThirdParallelCrankHasNoIsolatedClosureForAnySeed) {
  Mechanism mechanism = undriven("double-parallel-crank");
  mechanism.guess.clear();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.moves) << seed;
    EXPECT_EQ(result.counts.complex, 0u) << seed;
    EXPECT_EQ(result.paths.finite, result.paths.on_positive_dimensional) << seed;
  }
}

TEST(Moves, TypedEquationsToo) { expect_moves(undriven("slider-crank-equations"), 1); }

TEST(Moves, NotATriangleThatLiesFolded) {
  for (std::uint64_t seed = 1; seed <= kRandomSeeds; ++seed) {
    const ClosureResult result = closures_of(mechanism_text(test::triangle_text("3")), seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_FALSE(result.moves);
    ASSERT_EQ(result.closures.size(), 1u);
    EXPECT_TRUE(result.closures[0].singular);
    EXPECT_EQ(result.closures[0].multiplicity, 2u);
  }
}

TEST(Moves, NotAParallelogramThatIsHeldAtItsChangePoint) {
  for (std::uint64_t seed = 1; seed <= kRandomSeeds; ++seed) {
    const ClosureResult result = closures_of(mechanism_file("parallelogram"), seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_FALSE(result.moves);
    ASSERT_EQ(result.closures.size(), 1u);
    EXPECT_TRUE(result.closures[0].singular);
  }
}

TEST(Moves, AParallelogramAtItsChangePointOnceItsCrankIsFree) {
  expect_moves(undriven("parallelogram"), 1);
}

TEST(Moves, NotALinkThatDanglesFromAnAssembledTriangleSinceItIsHeld) {
  const ClosureResult result = closures_of(triangle_with_a_tail("2.5"));
  EXPECT_FALSE(result.moves);
  EXPECT_EQ(result.counts.real, 2U);
  ASSERT_EQ(result.idle.size(), 1U);
  EXPECT_EQ(result.idle[0].body, "tail");
}

// Each turns as it likes about a pin that all its joints share.
TEST(Moves, NotABlockOnACranksPinThatASlotAloneLeadsSinceItIsHeld) {
  const std::string text = R"toml([ground.points]
O = [0, 0]
Q = [0, -80]
[body.crank.points]
O = [0, 0]
A = [30, 40]
[body.block.points]
A = [5, 5]
[body.rocker.points]
Q = [0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "revolute"
at = ["ground.Q", "rocker.Q"]
[[joint]]
type = "revolute"
at = ["crank.A", "block.A"]
[[joint]]
type = "slot"
at = ["rocker.Q", "block.A"]
along = [0, 1]
[[driver]]
angle = "crank"
start = 0
)toml";
  const ClosureResult result = closures_of(mechanism_text(text));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_FALSE(result.moves);
  EXPECT_EQ(result.counts.real, 2U);
  ASSERT_EQ(result.idle.size(), 1U);
  EXPECT_EQ(result.idle[0].body, "block");

  const std::string driven = text + "[[driver]]\nangle = \"block\"\nstart = 0\n";
  const ClosureResult turned = closures_of(mechanism_text(driven));
  EXPECT_EQ(turned.idle.size(), 0U);
  EXPECT_EQ(turned.counts.real, 2U);
  std::string led = text;
  led.replace(led.find("\"slot\""), 6, "\"prismatic\"");
  const ClosureResult guided = closures_of(mechanism_text(led));
  EXPECT_EQ(guided.idle.size(), 0U);
  EXPECT_EQ(guided.counts.real, 2U);
}

// The outer pair turns on a wheel of the inner one: held to that, it is one with it.
TEST(Moves, NotAPairOfWheelsOnAWheelOfAPairSinceAllAreHeld) {
  std::string text = test::triangle_text("2.5");
  const auto wheel = [&](const std::string& name, const std::string& on) {
    text += "[body." + name + ".points]\nA = [0, 0]\n[[joint]]\ntype = \"revolute\"\nat = [\"" +
            on + ".A\", \"" + name + ".A\"]\n";
  };
  const auto mesh = [&](const std::string& a, const std::string& b, const std::string& carrier) {
    text += "[[joint]]\ntype = \"gear\"\nbodies = [\"" + a + "\", \"" + b +
            "\"]\nratio = [1, -2]\ncarrier = \"" + carrier + "\"\n";
  };
  wheel("inner1", "left");
  wheel("inner2", "left");
  mesh("inner1", "inner2", "left");
  wheel("outer1", "inner1");
  wheel("outer2", "inner1");
  mesh("outer1", "outer2", "inner1");
  const ClosureResult result = closures_of(mechanism_text(text));
  EXPECT_FALSE(result.moves) << result.message;
  EXPECT_EQ(result.counts.real, 2U);
  EXPECT_EQ(result.idle.size(), 2U);
}

TEST(Moves, WhatDanglesAllOverIsNotHeld) {
  Mechanism mechanism = triangle_with_a_tail("2.5");
  mechanism.joints.erase(mechanism.joints.begin() + 2);  // the tip: two links that hang from pivots
  expect_moves(mechanism, 3);
}

TEST(Moves, NotWhatDanglesFromATriangleThatCannotBeAssembled) {
  const ClosureResult result = closures_of(triangle_with_a_tail("4"));
  EXPECT_TRUE(result.complete) << result.message;
  EXPECT_FALSE(result.moves);
  EXPECT_EQ(result.counts.real, 0U);
  EXPECT_TRUE(result.closures.empty());
}

/// Links `left` and `right` over `base`; two links of 2, pinned to their tip and to each other,
/// turn about it as one.
Mechanism triangle_with_a_folded_pair(const std::string& base, const std::string& left = "3",
                                      const std::string& right = "4") {
  return mechanism_text("[ground.points]\nP = [0, 0]\nQ = [" + base + R"toml(, 0]
[body.left.points]
P = [0, 0]
R = [)toml" + left + ", 0]\n[body.right.points]\nQ = [0, 0]\nR = [" +
                        right + R"toml(, 0]
[body.one.points]
R = [0, 0]
T = [2, 0]
[body.other.points]
R = [0, 0]
T = [2, 0]
[[joint]]
type = "revolute"
at = ["ground.P", "left.P"]
[[joint]]
type = "revolute"
at = ["ground.Q", "right.Q"]
[[joint]]
type = "revolute"
at = ["left.R", "right.R"]
[[joint]]
type = "revolute"
at = ["left.R", "one.R"]
[[joint]]
type = "revolute"
at = ["left.R", "other.R"]
name = "R2"
[[joint]]
type = "revolute"
at = ["one.T", "other.T"]
)toml");
}

TEST(Moves, AFoldedPairOnATriangle) {
  const ClosureResult result = closures_of(triangle_with_a_folded_pair("5"));
  EXPECT_TRUE(result.complete) << result.message;
  ASSERT_TRUE(result.moves) << result.message;
  EXPECT_EQ(result.moves->dimension, 1U);
}

// The pair hangs on two links whose common place is known by two roundings: a star of joints makes
// it one.
TEST(Moves, AFoldedPairTypedOnTwoLinksOfOnePin) {
  for (Mechanism mechanism : {triangle_with_a_folded_pair("5"),
                              triangle_with_a_folded_pair("0.0537", "0.0311", "0.0429")}) {
    const auto right = mechanism.joints[2].at[1];
    Joint& second = mechanism.joints[4];
    ASSERT_EQ(second.name, "R2");
    second.at[0] = right;
    for (std::uint64_t seed = 1; seed <= kRandomSeeds; ++seed) {
      const ClosureResult result = closures_of(mechanism, seed);
      EXPECT_TRUE(result.complete) << result.message;
      ASSERT_TRUE(result.moves) << result.message;
      EXPECT_EQ(result.moves->dimension, 1U);
      EXPECT_EQ(result.paths.failed, 0U);
    }
  }
}

TEST(Moves, NotAFoldedPairOnATriangleThatCannotBeAssembled) {
  const ClosureResult result = closures_of(triangle_with_a_folded_pair("10"));
  EXPECT_TRUE(result.complete);
  EXPECT_FALSE(result.moves);
  EXPECT_EQ(result.message, "cannot be assembled: a part of it closes in complex numbers only");
}

TEST(Moves, ALinkThatTurnsInALoopInLineAlsoWithinAFit) {
  const std::string loop = R"toml(
space = "spatial"
[ground.points]
O = [0, 0, 0]
[body.b1.points]
O = [0, 0, 0]
A = [1, 0, 0]
[body.b2.points]
A = [1, 0, 0]
B = [3, 0, 0]
[body.b3.points]
B = [3, 0, 0]
O = [0, 0, 0]
[[joint]]
type = "revolute"
name = "j0"
at = ["ground.O", "b1.O"]
axis = [1, 0, 0]
[[joint]]
type = "universal"
at = ["b1.A", "b2.A"]
axis = [[0, 0, 1], [1, 0, 0]]
[[joint]]
type = "spherical"
at = ["b2.B", "b3.B"]
[[joint]]
type = "revolute"
at = ["b3.O", "ground.O"]
axis = [0, 0.6, 0.8]
[[driver]]
angle = "j0"
start = 0
)toml";
  for (const std::string fit : {"", "fit = 1e-3\n"}) {
    const ClosureResult result = closures_of(mechanism_text(fit + loop));
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_TRUE(result.moves) << fit << result.message;
  }
}

TEST(Moves, IsUndecidedWhereNoRealPoseIsFound) {
  const ClosureResult result = closures_of(mechanism_text(
      "[unknowns]\nlengths = [\"x\", \"y\"]\n[equations]\ncircle = \"x^2 + y^2 + 1\"\n"));
  EXPECT_FALSE(result.moves);
  EXPECT_FALSE(result.complete);
  EXPECT_EQ(result.message,
            "undecided: no closure is isolated, and Newton-Raphson came to no pose that moves "
            "from 32 starts; there may be none: give a guess, or drivers");
}

// A flat chain that is stretched as far as it goes: the complex closures are a curve, of which only
// the drawn pose is real.
TEST(Moves, OfACurveWithOneRealPoseTheDrawnPoseIsTold) {
  const ClosureResult result = closures_of(mechanism_text(R"toml(
space = "spatial"
[ground.points]
A = [4, 0, 0]
B = [-4, 0, 0]
[body.b1.points]
A = [4, 0, 0]
C = [6, 0, 0]
[body.b2.points]
C = [6, 0, 0]
D = [4, 0, 0]
[body.b3.points]
D = [4, 0, 0]
E = [2, 0, 0]
[body.b4.points]
E = [2, 0, 0]
B = [-4, 0, 0]
[[joint]]
type = "revolute"
name = "crank"
at = ["ground.A", "b1.A"]
axis = [0.6, 0, 0.8]
[[joint]]
type = "spherical"
at = ["b1.C", "b2.C"]
[[joint]]
type = "revolute"
at = ["b2.D", "b3.D"]
axis = [0, 0.6, 0.8]
[[joint]]
type = "revolute"
at = ["b3.E", "b4.E"]
axis = [0, 0.6, 0.8]
[[joint]]
type = "revolute"
at = ["b4.B", "ground.B"]
axis = [0, 0.6, 0.8]
[[driver]]
angle = "crank"
start = 0
)toml"));
  EXPECT_FALSE(result.moves);
  EXPECT_FALSE(result.complete);
  EXPECT_NE(result.message.find("the drawn pose closes and nothing was seen to move from it"),
            std::string::npos)
      << result.message;
}

// Of 13 equations in 12 unknowns a square choice may leave a set of roots that the last equation
// cuts.
TEST(Redundancy, TheOrderOfJointsDoesNotMatter) {
  Mechanism mechanism = mechanism_file("double-parallel-crank");
  std::vector<std::size_t> order{1, 2, 3, 4, 5, 0};
  const std::vector<Joint> joints = mechanism.joints;
  do {
    for (std::size_t k = 0; k < order.size(); ++k) mechanism.joints[k] = joints[order[k]];
    const ClosureResult result = closures_of(mechanism);
    ASSERT_TRUE(result.complete) << result.message;
    ASSERT_EQ(result.counts.complex, 1u);
    ASSERT_EQ(result.counts.real, 1u);
    ASSERT_FALSE(result.moves);
  } while (std::next_permutation(order.begin(), order.end() - 1));
}

TEST(Redundancy, ASquareChoiceWithASetOfRootsIsMixedWithTheSpareEquations) {
  const Mechanism mechanism = mechanism_text(R"toml(
[unknowns]
lengths = ["x", "y"]
[equations]
e1 = "(x - 1)*(y - 2)"
e2 = "(x - 1)*(y - 3)"
e3 = "(x - 1)*(y - 5) + (y - 5)"
)toml");
  for (std::uint64_t seed = 1; seed <= kRandomSeeds; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_FALSE(result.moves);
    ASSERT_EQ(result.closures.size(), 1u);
    EXPECT_NEAR(result.closures[0].q[0], 1, 1e-12);
    EXPECT_NEAR(result.closures[0].q[1], 5, 1e-12);
    EXPECT_EQ(result.stages.back().group, "dyad x, y, equations combined");
  }
}

// At x = 1, and at no other root before it, the second equation has lost its leading term.
TEST(Blocks, ThatAreLinearAtOneRootAreNotSoAtTheOthers) {
  for (const std::string constant : {"-2", "+2"}) {
    const Mechanism mechanism = mechanism_text(
        "[unknowns]\nlengths = [\"x\", \"y\"]\n[equations]\n"
        "one = \"x^2 - 0.5*x = 0.5\"\ntwo = \"(x - 1)*y^2 + y " +
        constant + " = 0\"\n");
    for (std::uint64_t seed = 1; seed <= kRandomSeeds; ++seed) {
      const ClosureResult result = closures_of(mechanism, seed);
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(result.counts.complex, 3u);
      EXPECT_EQ(result.counts.real, constant == "+2" ? 3u : 1u);
    }
  }
}

}  // namespace
}  // namespace moivre
