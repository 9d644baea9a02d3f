// SPDX-License-Identifier: MIT
// Counts over a mechanism's numbers: the borders of a four-bar and of a platform where closed forms
// have them.
#include "moivre/sweep/sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "../mechanism/files.h"
#include "moivre/mechanism/dimensions.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

using test::example;

SweepResult swept(const std::string& name, const std::vector<Varied>& varied) {
  const auto lanes = make_lane_tracker();
  FamilyBook book;
  SweepOptions options;
  options.closures.solve.threads = 2;
  return sweep(example(name), varied, *lanes, book, options);
}

TEST(Dimensions, AreNamedAndSet) {
  Mechanism mechanism = example("3-rpr");
  set_dimension(mechanism, "leg 1.length", 3);
  EXPECT_EQ(mechanism.joints[0].length, 3);
  set_dimension(mechanism, "platform.B2.x", 5);
  EXPECT_EQ(mechanism.bodies[1].points[1].at.x(), 5);
  EXPECT_THROW(set_dimension(mechanism, "leg 4.length", 1), std::invalid_argument);
  Mechanism four_bar = example("four-bar");
  set_dimension(four_bar, "crank", 90);
  EXPECT_NEAR(driver_state(four_bar.drivers[0].law, 5).value, std::acos(0.0), 1e-15);
}

TEST(Sweep, FindsWhereAFourBarCanNoLongerBeAssembled) {
  // Norton's four-bar, crank at 40 degrees of length a: coupler 120 and rocker 80 reach over the
  // diagonal e, e^2 = a^2 + 100^2 - 200 a cos 40 deg, while 40 <= e <= 200.
  const SweepResult result = swept("four-bar", {{"crank.A.x", 1, 299, 40}});
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.families, 1U);
  const double c = 100 * std::cos(40 * std::acos(-1.0) / 180);
  const double far = c + std::sqrt(c * c - 1e4 + 200.0 * 200);
  ASSERT_EQ(result.borders.size(), 1U);  // the diagonal stays above 64
  EXPECT_NEAR(result.borders[0].at[0], far, 1e-6);
  EXPECT_EQ(result.borders[0].below.real, 2U);
  EXPECT_EQ(result.borders[0].above.real, 0U);
  for (const SweepSample& sample : result.samples) EXPECT_EQ(sample.complex, 2U);
}

TEST(Sweep, FindsWhereAFittedClosureReachesALimit) {
  // Three parallel cranks, one pin a thousandth off: within fit only. The second crank turns with
  // the first, from 1 on.
  const Mechanism mechanism = read_mechanism({"typed", R"toml(fit = 0.01
[ground.points]
O = [0, 0]
P = [3, 0]
Q = [1.5, 0]
[body.crank.points]
O = [0, 0]
A = [1, 0]
[body.second.points]
P = [0, 0]
B = [1, 0]
[body.third.points]
Q = [0, 0]
C = [1, 0]
[body.bar.points]
A = [0, 0]
B = [3, 0]
C = [1.5, 0.001]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "revolute"
at = ["ground.P", "second.P"]
limits = [1, 4]
[[joint]]
type = "revolute"
at = ["ground.Q", "third.Q"]
[[joint]]
type = "revolute"
at = ["crank.A", "bar.A"]
[[joint]]
type = "revolute"
at = ["second.B", "bar.B"]
[[joint]]
type = "revolute"
at = ["third.C", "bar.C"]
[[driver]]
angle = "crank"
start = 0.5
)toml"});
  const auto lanes = make_lane_tracker();
  FamilyBook book;
  const SweepResult result = sweep(mechanism, {{"crank", 0.6, 1.5, 4}}, *lanes, book);
  EXPECT_TRUE(result.complete);
  ASSERT_EQ(result.borders.size(), 1U);
  EXPECT_NEAR(result.borders[0].at[0], 1, 1e-2);
  EXPECT_EQ(result.borders[0].below.usable(), 0U);
  EXPECT_EQ(result.borders[0].above.usable(), 1U);
}

TEST(Sweep, FindsTheDeadPointsOfADriver) {
  Mechanism mechanism = example("four-bar");
  set_dimension(mechanism, "crank.A.x", 150);
  const auto lanes = make_lane_tracker();
  FamilyBook book;
  const SweepResult result = sweep(mechanism, {{"crank", 0, 180, 37}}, *lanes, book);
  // e = 200: cos = (150^2 + 100^2 - 200^2) / (2 * 150 * 100).
  const double dead = std::acos(-7500.0 / 30000) * 180 / std::acos(-1.0);
  ASSERT_EQ(result.borders.size(), 1U);
  EXPECT_NEAR(result.borders[0].at[0], dead, 1e-6);
}

/// Crank 1 upright, rod 3: the slider's line is out of reach from 4 on. The middle sample lies
/// there, where the closures are double.
TEST(Sweep, HasABorderOnEachSideOfASampleThatLiesOnOne) {
  const Mechanism mechanism =
      test::typed("[units]\nangle = \"deg\"\n" + test::slider_crank_links(1, 3, 0) +
                  "[[driver]]\nangle = \"crank\"\nstart = 90\n");
  const auto lanes = make_lane_tracker();
  FamilyBook book;
  const SweepResult result =
      sweep(mechanism, {{"ground.G.y", 3.9999999, 4.0000001, 3}}, *lanes, book);
  ASSERT_EQ(result.borders.size(), 2U);
  EXPECT_EQ(result.borders[0].below.real, 2U);
  EXPECT_EQ(result.borders[0].above.real, 1U);
  EXPECT_EQ(result.borders[1].below.real, 1U);
  EXPECT_EQ(result.borders[1].above.real, 0U);
  for (const SweepBorder& border : result.borders) EXPECT_NEAR(border.at[0], 4, 1e-9);
}

TEST(Sweep, MapsTheAssembliesOfAPlatform) {
  const SweepResult result =
      swept("3-rpr", {{"leg 1.length", 8, 22, 8}, {"leg 2.length", 8, 22, 8}});
  EXPECT_TRUE(result.complete);
  EXPECT_FALSE(result.borders.empty());
  std::set<std::uint64_t> counts;
  for (const SweepSample& sample : result.samples) {
    EXPECT_EQ(sample.complex, 6U);
    EXPECT_EQ(sample.found.real % 2, 0U);
    counts.insert(sample.found.real);
  }
  EXPECT_GE(counts.size(), 2U);
}

/// A slider-crank whose slider may go from 0 to 3, crank 1 along the line: closures at 1 - rod and
/// 1 + rod.
TEST(Sweep, TellsClosuresOutsideLimitsAndWhereTheyGetThere) {
  Mechanism mechanism =
      test::typed("[units]\nangle = \"deg\"\n" + test::slider_crank_links(1, 3, 0) +
                  "[[driver]]\nangle = \"crank\"\nstart = 0\n");
  for (Joint& joint : mechanism.joints) {
    if (joint.type == JointType::prismatic) joint.limits = Limits{0, 3};
  }
  const auto lanes = make_lane_tracker();
  FamilyBook book;
  SweepOptions options;
  options.keep_closures = true;
  const SweepResult result = sweep(mechanism, {{"rod.B.x", 0.5, 3.7, 9}}, *lanes, book, options);
  EXPECT_TRUE(result.complete);
  for (const SweepSample& sample : result.samples) {
    const double rod = sample.at[0];
    EXPECT_EQ(sample.found.real, 2U);
    EXPECT_EQ(sample.found.filtered, rod > 2 ? 2U : rod > 1 ? 1U : 0U) << rod;
    EXPECT_EQ(sample.closures.size(), sample.found.usable());
  }
  ASSERT_EQ(result.borders.size(), 2U);
  EXPECT_NEAR(result.borders[0].at[0], 1, 1e-8);
  EXPECT_NEAR(result.borders[1].at[0], 2, 1e-8);
  EXPECT_EQ(result.borders[1].below.filtered, 1U);
  EXPECT_EQ(result.borders[1].above.filtered, 2U);
}

/// The slider is held over the pivot: the rod turns where it is as long as the crank, and closes
/// nowhere else.
TEST(Sweep, TellsWhereTheMechanismMoves) {
  const Mechanism mechanism =
      test::typed(test::slider_crank_links(1, 3, 0) + "[[driver]]\nx = \"slider.B\"\nstart = 0\n");
  const auto lanes = make_lane_tracker();
  FamilyBook book;
  const SweepResult result = sweep(mechanism, {{"rod.B.x", 0.5, 1.5, 5}}, *lanes, book);
  ASSERT_EQ(result.borders.size(), 2U);
  EXPECT_FALSE(result.borders[0].below.moves);
  EXPECT_TRUE(result.borders[0].above.moves);
  EXPECT_TRUE(result.borders[1].below.moves);
  EXPECT_FALSE(result.borders[1].above.moves);
}

TEST(Sweep, NamesEveryFault) {
  const auto lanes = make_lane_tracker();
  FamilyBook book;
  EXPECT_THROW(sweep(example("four-bar"), {}, *lanes, book), std::invalid_argument);
  EXPECT_THROW(sweep(example("four-bar"), {{"crank.Q.x", 0, 1, 5}}, *lanes, book),
               std::invalid_argument);
  EXPECT_THROW(sweep(example("four-bar"), {{"crank", 0, 0, 5}}, *lanes, book),
               std::invalid_argument);
}

}  // namespace
}  // namespace moivre
