// SPDX-License-Identifier: MIT
// Do belts turn pulleys in the ratio of their radii, open and crossed, as gears of that ratio do?
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mechanisms.h"

namespace moivre {
namespace {

constexpr double kBeltDegree = std::numbers::pi / 180;

/// Two pulleys on an arm that turns by 20 degrees, the first driven.
Mechanism pulleys(const std::string& belt, const std::string& angle_deg) {
  const auto pin = [](const std::string& a, const std::string& b) {
    return "[[joint]]\ntype = \"revolute\"\nat = [\"" + a + "\", \"" + b + "\"]\n";
  };
  return mechanism_text(R"toml(
[units]
angle = "deg"
[ground.points]
O = [0, 0]
[body.arm.points]
O = [0, 0]
P = [10, 0]
[body.small.points]
O = [0, 0]
[body.large.points]
P = [0, 0]
)toml" + pin("ground.O", "arm.O") +
                        pin("ground.O", "small.O") + pin("arm.P", "large.P") +
                        "[[joint]]\ntype = \"belt\"\nbodies = [\"small\", \"large\"]\n"
                        "carrier = \"arm\"\n" +
                        belt + "[[driver]]\nangle = \"arm\"\nstart = 20\n" +
                        "[[driver]]\nangle = \"small\"\nstart = " + angle_deg + "\n");
}

TEST(ABelt, TurnsItsPulleysByTheirRadiiAsSeenFromTheCarrier) {
  for (const double angle : {-700.0, 33.0, 1000.0}) {
    for (const bool is_crossed : {false, true}) {
      const Mechanism m = pulleys(std::string("radii = [25.4, 60.96]\nphase = 5\n") +
                                      (is_crossed ? "crossed = true\n" : ""),
                                  std::to_string(angle));
      const int sign = is_crossed ? -1 : 1;
      EXPECT_EQ(m.joints[3].gear.teeth[0], 5 * sign);
      EXPECT_EQ(m.joints[3].gear.teeth[1], 12);
      for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const ClosureResult result = closures_of(m, seed);
        EXPECT_TRUE(result.complete) << result.message;
        ASSERT_EQ(result.closures.size(), 1U);
        const double turned = 20 + 5 + sign * (angle - 20) * 5 / 12;
        EXPECT_NEAR(
            std::remainder(result.closures[0].q[8] - turned * kBeltDegree, 2 * std::numbers::pi), 0,
            1e-12);
      }
    }
  }
}

TEST(ABelt, HasTheClosuresOfAGearOfItsRatio) {
  const Mechanism belt = mechanism_file("belt-five-bar");
  Mechanism gear = belt;
  gear.joints[5].type = JointType::gear;
  gear.joints[5].gear.teeth = {-40, 20};
  for (const bool all : {false, true}) {
    Mechanism one = belt, other = gear;
    one.joints[5].gear.has_all_meshings = all;
    other.joints[5].gear.has_all_meshings = all;
    const ClosureResult by_belt = closures_of(one);
    const ClosureResult by_gear = closures_of(other);
    EXPECT_EQ(by_belt.counts.complex, by_gear.counts.complex);
    ASSERT_EQ(by_belt.closures.size(), by_gear.closures.size());
    for (std::size_t k = 0; k < by_belt.closures.size(); ++k) {
      EXPECT_LT((by_belt.closures[k].q - by_gear.closures[k].q).norm(), 1e-14);
    }
  }
}

TEST(ABelt, MayHaveRadiiOfManyDecimalsInARatioOfWholeNumbers) {
  EXPECT_EQ(pulleys("radii = [0.1, 0.3]\n", "1").joints[3].gear.teeth[1], 3);
  EXPECT_EQ(pulleys("radii = [12.345678, 24.691356]\n", "1").joints[3].gear.teeth[1], 2);
  EXPECT_EQ(pulleys("radii = [30, 45]\n", "1").joints[3].gear.teeth[0], 2);
}

}  // namespace
}  // namespace moivre
