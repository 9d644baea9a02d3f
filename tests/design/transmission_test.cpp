// SPDX-License-Identifier: MIT
// Is the transmission angle the one of the textbooks, and defined where they define it?
#include "followed.h"
#include "moivre/mechanism/pose.h"

namespace moivre::test {
namespace {

const QuantityChoice kTransmission = groups({QuantityGroup::transmission});

double acute(double angle) { return std::acos(std::abs(std::cos(angle))); }

TEST(TransmissionAngle, OfAFourBarFollowsFromTheLawOfCosines) {
  const double a = 40, b = 120, c = 80, d = 100;
  const Followed all = followed(typed(four_bar_text(a, b, c, d)), kTransmission);
  ASSERT_EQ(all.readings.quantities.size(), 1U);
  EXPECT_EQ(all.readings.quantities[0].name, "coupler-rocker transmission");
  for (std::size_t k = 0; k < all.samples().size(); ++k) {
    const double theta = all.samples()[k].q[2];
    const double diagonal = a * a + d * d - 2 * a * d * std::cos(theta);
    const double mu = acute(std::acos((b * b + c * c - diagonal) / (2 * b * c)));
    EXPECT_NEAR(all.value("coupler-rocker transmission", k), mu, 1e-9) << k;
  }
}

TEST(TransmissionAngle, IsLeastWhereTheCrankLiesOnTheGround) {
  const double a = 40, b = 120, c = 80, d = 100;
  for (const int steps : {7, 23, 90}) {
    const Followed all = followed(typed(four_bar_text(a, b, c, d)), kTransmission, steps);
    const Extreme least = all.extremes("coupler-rocker transmission").least;
    const double at_zero = std::acos((b * b + c * c - (d - a) * (d - a)) / (2 * b * c));
    const double at_half = kPi - std::acos((b * b + c * c - (d + a) * (d + a)) / (2 * b * c));
    EXPECT_NEAR(least.value, std::min(at_zero, at_half), 1e-9) << steps;
    EXPECT_TRUE(least.is_refined);
    EXPECT_NEAR(std::cos(driver_values(all.mechanism, least.time)[0]), at_zero < at_half ? 1 : -1,
                1e-6);
  }
}

TEST(TransmissionAngle, OfASliderCrankIsThatBetweenRodAndNormal) {
  const double r = 40, l = 120, e = 15;
  const Followed all = followed(typed(slider_crank_text(r, l, e)), kTransmission);
  for (std::size_t k = 0; k < all.samples().size(); ++k) {
    const double theta = all.samples()[k].q[2];
    EXPECT_NEAR(all.value("rod-slider transmission", k),
                std::acos(std::abs(r * std::sin(theta) - e) / l), 1e-9);
  }
  EXPECT_NEAR(all.extremes("rod-slider transmission").least.value, std::acos((r + e) / l), 1e-9);
  EXPECT_NEAR(all.extremes("rod-slider transmission").largest.value, kPi / 2, 1e-6);
}

TEST(TransmissionAngle, OfARodIsThatOfTheBodyInItsPlace) {
  std::string text = four_bar_text(40, 120, 80, 100);
  const std::size_t begin = text.find("[body.coupler.points]");
  text.erase(begin, text.find("[body.rocker.points]") - begin);
  const std::size_t joints = text.find("[[joint]]\ntype = \"revolute\"\nat = [\"crank.A\"");
  const std::size_t behind = text.find("[[joint]]\ntype = \"revolute\"\nat = [\"ground.P\"");
  text.replace(joints, behind - joints,
               "[[joint]]\ntype = \"rod\"\nat = [\"crank.A\", \"rocker.B\"]\nlength = 120\n");
  text.erase(text.find("\"coupler.phi\" = 20\n"), 19);
  const Followed rod = followed(typed(text), kTransmission);
  const Followed body = followed(typed(four_bar_text(40, 120, 80, 100)), kTransmission);
  for (std::size_t k = 0; k < rod.samples().size(); ++k) {
    EXPECT_NEAR(rod.value("crank-rocker transmission", k),
                body.value("coupler-rocker transmission", k), 1e-9);
  }
}

TEST(TransmissionAngle, OfAPinInASlotIsThatOfTheSlotsNormal) {
  const Followed yoke = followed(example("scotch-yoke"), kTransmission);
  ASSERT_EQ(yoke.readings.quantities.size(), 1U);
  EXPECT_NEAR(yoke.extremes("yoke-crank transmission").least.value, kPi / 2, 1e-9);
  const Followed lever = followed(example("whitworth"), kTransmission);
  EXPECT_NEAR(lever.extremes("lever-crank transmission").least.value, kPi / 2, 1e-9);
  EXPECT_TRUE(lever.has("link-ram transmission"));
  EXPECT_EQ(lever.readings.quantities.size(), 2U);
}

TEST(TransmissionAngle, IsToldForTheFloatingJointOfEachDyad) {
  for (const auto& [name, last] : {std::pair("watt-1", "link5-link6 transmission"),
                                   std::pair("stephenson-3", "link6-link5 transmission")}) {
    const Followed all = followed(example(name), kTransmission);
    EXPECT_EQ(all.readings.quantities.size(), 2U) << name;
    EXPECT_TRUE(all.has("coupler-rocker transmission")) << name;
    EXPECT_TRUE(all.has(last)) << name;
  }
}

TEST(TransmissionAngle, OfADyadIsTheAngleAtItsFloatingJoint) {
  const Followed all = followed(example("watt-1"), kTransmission);
  for (std::size_t k = 0; k < all.samples().size(); ++k) {
    const auto& q = all.samples()[k].q;
    EXPECT_NEAR(all.value("link5-link6 transmission", k), acute(q[11] - q[14]), 1e-9);
  }
}

/// A platform on three cranked legs: driven at one, a group of three links and more, no dyads.
TEST(TransmissionAngle, OfLargerGroupsTurnsAboutTheMomentaryCentre) {
  const Followed all = followed(typed(R"toml([units]
angle = "deg"
[ground.points]
A = [0, 0]
B = [10, 0]
C = [5, 9]
[body.crank.points]
A = [0, 0]
D = [2, 0]
[body.left.points]
D = [0, 0]
P = [4, 0]
[body.right.points]
B = [0, 0]
Q = [5, 0]
[body.top.points]
C = [0, 0]
R = [4, 0]
[body.plate.points]
P = [0, 0]
Q = [3, 0]
R = [1.5, 2]
[[joint]]
type = "revolute"
at = ["ground.A", "crank.A"]
[[joint]]
type = "revolute"
at = ["crank.D", "left.D"]
[[joint]]
type = "revolute"
at = ["left.P", "plate.P"]
[[joint]]
type = "revolute"
at = ["ground.B", "right.B"]
[[joint]]
type = "revolute"
at = ["right.Q", "plate.Q"]
[[joint]]
type = "revolute"
at = ["ground.C", "top.C"]
[[joint]]
type = "revolute"
at = ["top.R", "plate.R"]
[[driver]]
angle = "crank"
start = 90
velocity = 10
[guess]
"left.phi" = 35
"right.phi" = 149
"top.phi" = 279
"plate.phi" = -36
)toml"),
                                kTransmission, 20, 1);
  ASSERT_FALSE(all.samples().empty());
  ASSERT_TRUE(all.has("left-plate transmission"));
  const Mechanism& m = all.mechanism;
  const auto& q = all.samples().front().q;
  const auto at = [&](std::size_t body, std::size_t point) {
    return point_position(m, {body, point}, q);
  };
  // The plate turns about where the lines of the right and the top leg meet.
  const Eigen::Vector3d B(10, 0, 0), C(5, 9, 0), Q = at(5, 1), R = at(5, 2), P = at(5, 0);
  Eigen::Matrix2d lines;
  lines << (Q - B).head<2>(), -(R - C).head<2>();
  const double det = lines(0, 0) * lines(1, 1) - lines(0, 1) * lines(1, 0);
  const Eigen::Vector2d gap = (C - B).head<2>();
  const double s = (gap.x() * lines(1, 1) - gap.y() * lines(0, 1)) / det;
  const Eigen::Vector3d centre = B + s * (Q - B);
  const Eigen::Vector3d arm = P - centre, leg = P - at(2, 0);
  const double expected =
      std::atan2(std::abs(arm.x() * leg.y() - arm.y() * leg.x()), std::abs(arm.dot(leg)));
  EXPECT_NEAR(all.value("left-plate transmission", 0), expected, 1e-9);
}

TEST(TransmissionAngle, VanishesAtADeadPoint) {
  const Followed all = followed(typed(four_bar_text(90, 60, 60, 100, "30", "10")), kTransmission);
  ASSERT_TRUE(all.motion.branches.front().end_event.has_value());
  const Extreme least = all.extremes("coupler-rocker transmission").least;
  EXPECT_NEAR(least.value, 0, 1e-4);
  EXPECT_NEAR(least.time, all.motion.branches.front().ends, 1e-9);
}

}  // namespace
}  // namespace moivre::test
