// SPDX-License-Identifier: MIT
// Are extremes those of the motion and not of its samples, and quick returns those of the drawing
// board?
#include "followed.h"

namespace moivre::test {
namespace {

TEST(TimeRatio, OfAnOffsetSliderCrankFollowsFromItsDeadCentres) {
  const double r = 40, l = 120;
  for (const double e : {15.0, 30.0, -20.0}) {
    for (const int steps : {16, 90}) {
      const Followed all = followed(typed(slider_crank_text(r, l, e)), {}, steps);
      const auto& ratios = all.readings.branches.front().time_ratios;
      ASSERT_EQ(ratios.size(), 1U);
      EXPECT_EQ(ratios[0].output, "guide");
      const double swing = std::abs(std::asin(e / (l - r)) - std::asin(e / (l + r)));
      EXPECT_NEAR(ratios[0].ratio, (kPi + swing) / (kPi - swing), 1e-6) << e;
      EXPECT_NEAR(ratios[0].rising_s + ratios[0].falling_s, 360, 1e-9);
      EXPECT_NEAR(ratios[0].to, std::sqrt((l + r) * (l + r) - e * e), 1e-8);
      EXPECT_NEAR(ratios[0].from, std::sqrt((l - r) * (l - r) - e * e), 1e-8);
    }
  }
}

TEST(TimeRatio, OfACrankRockerFollowsFromItsToggles) {
  const double a = 40, b = 120, c = 80, d = 100;
  const auto angle = [&](double side) {
    return std::acos((d * d + side * side - c * c) / (2 * d * side));
  };
  const double swing = std::abs(angle(b + a) - angle(b - a));
  for (const char* velocity : {"1", "-1"}) {
    const Followed all = followed(typed(four_bar_text(a, b, c, d, "30", velocity)), {}, 72);
    const auto& ratios = all.readings.branches.front().time_ratios;
    ASSERT_EQ(ratios.size(), 1U);
    EXPECT_EQ(ratios[0].output, "rocker");
    EXPECT_NEAR(ratios[0].ratio, (kPi + swing) / (kPi - swing), 1e-6);
  }
}

TEST(TimeRatio, OfSymmetryIsOne) {
  const Followed yoke = followed(example("scotch-yoke"), {});
  ASSERT_EQ(yoke.readings.branches.front().time_ratios.size(), 1U);
  EXPECT_NEAR(yoke.readings.branches.front().time_ratios[0].ratio, 1, 1e-6);
}

TEST(TimeRatio, OfWhitworthsDriveIsThatOfItsTangents) {
  // The lever turns back where the crank stands across it: cos(alpha) = crank / ground.
  const Followed all = followed(example("whitworth"), {{}, {"lever"}}, 120);
  const auto& ratios = all.readings.branches.front().time_ratios;
  ASSERT_EQ(ratios.size(), 1U);
  const double quick = 2 * std::acos(1.5 / 3);
  EXPECT_NEAR(ratios[0].ratio, (2 * kPi - quick) / quick, 1e-6);
}

// The rocker's hinge goes from 114 to 180.3 degrees, over half a turn, where its angle is told as
// -179.7.
TEST(TimeRatio, OfAHingeGoesOnOverHalfATurn) {
  const Mechanism rssr = typed(R"toml(space = "spatial"
[units]
length = "mm"
angle = "deg"
[ground.points]
O = [0, 0, 0]
Q = [100, 50, 30]
[body.crank.points]
O = [0, 0, 0]
A = [0, 30, 0]
[body.rocker.points]
Q = [100, 50, 30]
B = [100, 50, 110]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
axis = [0, 0, 1]
name = "crank"
[[joint]]
type = "rod"
at = ["crank.A", "rocker.B"]
length = 150
[[joint]]
type = "revolute"
at = ["ground.Q", "rocker.Q"]
axis = [0, 1, 0]
name = "rocker"
[[driver]]
angle = "crank"
velocity = 1
[guess]
rocker.ry = 147
)toml");
  const Followed all = followed(rssr, {});
  const auto& ratios = all.readings.branches.front().time_ratios;
  ASSERT_EQ(ratios.size(), 1U);
  EXPECT_NEAR(ratios[0].from * 180 / kPi, 114.347, 1e-3);
  EXPECT_NEAR(ratios[0].to * 180 / kPi, 180.306, 1e-3);
  EXPECT_NEAR(ratios[0].ratio, 1.124, 1e-3);
}

TEST(TimeRatio, IsNotToldOfWhatGoesRoundOrComesToNoEnd) {
  // A drag link: both cranks go round.
  const Followed drag = followed(typed(four_bar_text(100, 90, 95, 40)), {});
  ASSERT_TRUE(drag.motion.complete);
  EXPECT_TRUE(drag.readings.branches.front().time_ratios.empty());
  const Followed dead = followed(typed(four_bar_text(90, 60, 60, 100, "30", "10")), {});
  EXPECT_TRUE(dead.readings.branches.front().time_ratios.empty());
  // The crank makes half a turn while the motor makes one.
  std::string geared = slider_crank_text(15, 95, 0);
  geared.replace(geared.find("[body.rod.points]"), 0, "[body.motor.points]\nM = [0, 0]\n");
  geared.replace(geared.find("G = [0, "), 0, "M = [-40, 0]\n");
  geared.replace(
      geared.find("[[driver]]\nangle = \"crank\""), 26,
      "[[joint]]\ntype = \"revolute\"\nat = [\"ground.M\", \"motor.M\"]\n[[joint]]\ntype = "
      "\"gear\"\nbodies = [\"motor\", \"crank\"]\nratio = [20, 40]\n[[driver]]\nangle = "
      "\"motor\"");
  const Followed gear = followed(typed(geared), {{}, {"guide"}});
  ASSERT_TRUE(gear.motion.complete);
  EXPECT_TRUE(gear.readings.branches.front().time_ratios.empty());
  const Followed half = followed(typed(four_bar_text(40, 120, 80, 100)), {}, 90, 180);
  EXPECT_TRUE(half.readings.branches.front().time_ratios.empty());
}

TEST(Extremes, AreThoseOfTheMotionBetweenTheSamples) {
  const QuantityChoice choice =
      groups({QuantityGroup::joints, QuantityGroup::transmission, QuantityGroup::coefficients});
  const Mechanism m = typed(four_bar_text(40, 120, 80, 100));
  const Followed coarse = followed(m, choice, 24);
  const Followed fine = followed(m, choice, 5000);
  ASSERT_EQ(coarse.readings.quantities.size(), fine.readings.quantities.size());
  for (std::size_t k = 0; k < coarse.readings.quantities.size(); ++k) {
    const Extremes& rough = coarse.readings.branches.front().extremes[k];
    double least = 1e300, largest = -1e300;
    for (const auto& row : fine.readings.branches.front().values) {
      least = std::min(least, row[k]);
      largest = std::max(largest, row[k]);
    }
    const double tolerance = 1e-5 * (largest - least) + 1e-12;
    EXPECT_NEAR(rough.least.value, least, tolerance) << coarse.readings.quantities[k].name;
    EXPECT_NEAR(rough.largest.value, largest, tolerance) << coarse.readings.quantities[k].name;
  }
}

TEST(Extremes, OfTheRockersSwingAreItsToggles) {
  const double a = 40, b = 120, c = 80, d = 100;
  const Followed all =
      followed(typed(four_bar_text(a, b, c, d)), groups({QuantityGroup::coordinates}), 30);
  const auto rocker_at = [&](double side) {
    return kPi - std::acos((d * d + c * c - side * side) / (2 * d * c));
  };
  const Extremes& swing = all.extremes("rocker.phi");
  EXPECT_NEAR(swing.least.value, std::min(rocker_at(b - a), rocker_at(b + a)), 1e-9);
  EXPECT_NEAR(swing.largest.value, std::max(rocker_at(b - a), rocker_at(b + a)), 1e-9);
  EXPECT_NEAR(all.extremes("crank.phi").largest.value - all.extremes("crank.phi").least.value,
              2 * kPi, 1e-9);
}

/// s = 2 cos phi + sqrt(25 - 4 sin^2 phi) of a slider-crank; its acceleration at the limit s = 5,
/// where phi' = 1 degree a second.
TEST(Extremes, BesideALimitDoNotHangOnTheSamples) {
  std::string text = slider_crank_text(2, 5, 0);
  const std::string name = "name = \"guide\"\n";
  text.insert(text.find(name) + name.size(), "limits = [5, 7]\n");
  const double phi =
      std::acos(1.0 / 5);  // crank 2, and rod and slide both 5: an isosceles triangle
  const double cosine = std::cos(phi), sine = std::sin(phi);
  const double root = std::sqrt(25 - 4 * sine * sine);
  const double bend = -2 * cosine - 4 * (cosine * cosine - sine * sine) / root -
                      16 * sine * sine * cosine * cosine / (root * root * root);
  const double acceleration = bend * (kPi / 180) * (kPi / 180);
  for (const int steps : {7, 60, 1000}) {
    const Followed all = followed(typed(text), groups({QuantityGroup::joints}), steps);
    ASSERT_TRUE(all.motion.branches.front().end_event.has_value());
    const Extremes& found = all.extremes("joint guide.acceleration");
    EXPECT_NEAR(found.largest.value, acceleration, 1e-9) << steps;
    EXPECT_NEAR(found.largest.time, all.motion.branches.front().ends, 1e-9) << steps;
  }
}

/// The coupler's angle runs to its value at a dead point as a square root does.
TEST(Extremes, AtADeadPointDoNotHangOnTheSamples) {
  const Mechanism m = typed(four_bar_text(90, 60, 60, 100, "30", "10"));
  const QuantityChoice choice = groups({QuantityGroup::transmission});
  const Followed coarse = followed(m, choice, 9);
  const Followed fine = followed(m, choice, 3000);
  for (std::size_t k = 0; k < coarse.readings.quantities.size(); ++k) {
    const Extremes& rough = coarse.readings.branches.front().extremes[k];
    const Extremes& sharp = fine.readings.branches.front().extremes[k];
    EXPECT_NEAR(rough.least.value, sharp.least.value, 1e-4) << coarse.readings.quantities[k].name;
    EXPECT_NEAR(rough.largest.value, sharp.largest.value, 1e-4);
  }
}

TEST(Extremes, OfVelocitiesAreUnboundedAtADeadPoint) {
  const Followed all = followed(typed(four_bar_text(90, 60, 60, 100, "30", "10")),
                                groups({QuantityGroup::coordinates, QuantityGroup::singularity}));
  const auto& branch = all.motion.branches.front();
  ASSERT_TRUE(branch.end_event.has_value());
  const Extremes& velocity = all.extremes("rocker.phi.velocity");
  EXPECT_TRUE(velocity.least.is_unbounded() != velocity.largest.is_unbounded());
  EXPECT_FALSE(all.extremes("crank.phi.velocity").largest.is_unbounded());
  EXPECT_FALSE(all.extremes("crank.phi.velocity").least.is_unbounded());
  EXPECT_NEAR(all.extremes("distance to singularity").least.value, 0, 1e-6);
  EXPECT_NEAR(all.extremes("distance to singularity").least.time, branch.ends, 1e-9);
}

TEST(JointReadings, AreTheDifferencesOfTheirBodies) {
  const Followed all =
      followed(typed(four_bar_text(40, 120, 80, 100)), groups({QuantityGroup::joints}), 40);
  for (std::size_t k = 0; k < all.samples().size(); ++k) {
    const BranchSample& at = all.samples()[k];
    EXPECT_NEAR(std::remainder(all.value("joint B", k) - (at.q[8] - at.q[5]), 2 * kPi), 0, 1e-12);
    EXPECT_NEAR(all.value("joint B.velocity", k), at.velocity[8] - at.velocity[5], 1e-12);
    EXPECT_NEAR(all.value("joint B.acceleration", k), at.acceleration[8] - at.acceleration[5],
                1e-12);
  }
}

TEST(JointReadings, OfSlidesAndSpatialHingesAgreeWithTheirDifferences) {
  for (const char* name : {"whitworth", "inverted-slider-crank", "rssr", "rccc"}) {
    const Mechanism m = example(name);
    const Followed all = followed(m, groups({QuantityGroup::joints}), 4000, 0.5);
    ASSERT_GT(all.samples().size(), 3U) << name;
    const double h = all.samples()[1].time - all.samples()[0].time;
    const auto& rows = all.readings.branches.front().values;
    for (std::size_t q = 0; q < all.readings.quantities.size(); ++q) {
      if (all.readings.quantities[q].order == QuantityOrder::acceleration) continue;
      for (std::size_t k = 1; k + 1 < rows.size(); k += 97) {
        const double size = 1 + std::abs(rows[k][q + 1]);
        EXPECT_NEAR((rows[k + 1][q] - rows[k - 1][q]) / (2 * h), rows[k][q + 1], 1e-4 * size)
            << name << ' ' << all.readings.quantities[q].name;
      }
    }
  }
}

TEST(Readings, HoldWheelsThatSpinIdly) {
  const Mechanism roller = read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/tests/trial/files/roller.toml"));
  const Followed all =
      followed(roller, groups({QuantityGroup::transmission, QuantityGroup::coefficients}));
  for (std::size_t q = 0; q < all.readings.quantities.size(); ++q) {
    EXPECT_TRUE(std::isfinite(all.readings.branches.front().values.front()[q]))
        << all.readings.quantities[q].name;
  }
}

}  // namespace
}  // namespace moivre::test
