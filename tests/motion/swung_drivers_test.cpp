// SPDX-License-Identifier: MIT
// Is every branch found where a driver swings to and fro, so that checkpoints fall on its turns and
// on poses that have lost roots?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanisms.h"
#include "moivre/motion/motion.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {
namespace {

MotionResult motion_for_a_second(const std::string& text, std::uint64_t seed) {
  MotionOptions options;
  options.to = 1;
  options.solve.seed = seed;
  return find_motion(mechanism_text(text), *make_cvode_tracker(), options);
}

/// Crank 2, rod 5; the slide is driven, and the two closures are real where 3 <= s <= 7.
std::string slider_crank(const std::string& law) {
  return test::slider_crank_links(2, 5, 0) + "[[driver]]\nslide = \"guide\"\nvalue = \"" + law +
         "\"\n";
}

// Both closures are real for a while in each half swing; at s = 0 they are at infinity, at s = 10
// the driver stands.
TEST(ASwungSlide, HasTwoBranchesInEachHalfSwing) {
  for (const int swings : {1, 2, 4, 10}) {
    const std::string law = "5 + 5*cos(" + std::to_string(2 * swings) + "*pi*t)";
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(law + ", seed " + std::to_string(seed));
      const MotionResult motion = motion_for_a_second(slider_crank(law), seed);
      EXPECT_TRUE(motion.complete) << motion.message;
      ASSERT_EQ(motion.branches.size(), 4U * static_cast<std::size_t>(swings));
      const double first = std::acos(0.4) / (2 * std::numbers::pi * swings);  // s = 7
      const double last = std::acos(-0.4) / (2 * std::numbers::pi * swings);  // s = 3
      for (std::size_t k : {0U, 1U}) {
        EXPECT_NEAR(motion.branches[k].begins, first, 1e-9);
        EXPECT_NEAR(motion.branches[k].ends, last, 1e-9);
      }
    }
  }
}

// From a dead point on, to rounding: where both closures begin they live on, and where they end
// those of the later half swings are found.
TEST(ASwungSlide, HasItsLaterBranchesWhenItBeginsAtADeadPoint) {
  const double period = 4 * std::numbers::pi;
  for (const auto& [begin, branches] :
       {std::pair(std::acos(0.4), 8), std::pair(std::acos(-0.4), 6)}) {
    for (const double off : {0.0, 1e-16, -1e-16, 3e-16}) {
      MotionOptions options;
      options.from = begin / period + off;
      options.to = 1;
      const MotionResult motion = find_motion(mechanism_text(slider_crank("5 + 5*cos(4*pi*t)")),
                                              *make_cvode_tracker(), options);
      EXPECT_TRUE(motion.complete) << motion.message;
      const auto lives = [](const MotionBranch& b) { return b.ends - b.begins > 1e-3; };
      EXPECT_EQ(std::count_if(motion.branches.begin(), motion.branches.end(), lives), branches)
          << options.from;
    }
  }
}

// At every checkpoint but one the coupler and the crank are too short for the rocker's angle.
TEST(ASwungRocker, HasFourBranchesBetweenCheckpoints) {
  const std::string text = R"toml([units]
angle = "deg"
[ground.points]
O = [1, -5]
Q = [1, 2]
[body.a.points]
O = [1, -5]
A = [2, -4]
[body.b.points]
A = [2, -4]
B = [-4, -2]
[body.c.points]
B = [-4, -2]
Q = [1, 2]
[[joint]]
type = "revolute"
at = ["ground.O", "a.O"]
[[joint]]
type = "revolute"
at = ["a.A", "b.A"]
[[joint]]
type = "revolute"
at = ["b.B", "c.B"]
[[joint]]
type = "revolute"
at = ["ground.Q", "c.Q"]
[[driver]]
angle = "c"
value = "-30 + 75*cos(2*pi*t)"
)toml";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const MotionResult motion = motion_for_a_second(text, seed);
    EXPECT_TRUE(motion.complete) << motion.message;
    ASSERT_EQ(motion.branches.size(), 4U) << seed;
    // |O B| is the sum of crank and coupler, or their difference, at these times, by circles.
    EXPECT_NEAR(motion.branches.front().begins, 0.16384, 1e-5);
    EXPECT_NEAR(motion.branches.front().ends, 0.22665, 1e-5);
    EXPECT_NEAR(motion.branches.back().ends, 1 - 0.16384, 1e-5);
  }
}

// y = 1 + 1.5 sin: at every checkpoint the crank stands at its highest point, where two closures
// meet. The crank's angle at the dead points, where the rod and the rocker lie in a line, is by
// circles; two branches begin or end at each.
TEST(ASwungPoint, HasTheBranchesBetweenItsDeadPointsThoughNoCheckpointShowsOne) {
  const std::string text = R"toml([ground.points]
O = [0, 0]
Q = [-5, -4]
[body.crank.points]
O = [0, 0]
A = [0, 1]
B = [0, -3]
[body.rocker.points]
Q = [0, 0]
C = [1, -2]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "revolute"
at = ["ground.Q", "rocker.Q"]
[[joint]]
type = "rod"
at = ["crank.B", "rocker.C"]
length = 8
[[driver]]
y = "crank.A"
value = "1 + 1.5*sin(4*pi*t)"
)toml";
  // Where |B Q| = 8 - |Q C|; the driver passes each height on its way down and on its way up.
  const auto down = [](double height) {
    return 0.25 + std::asin((1 - height) / 1.5) / (4 * std::numbers::pi);
  };
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const MotionResult motion = motion_for_a_second(text, seed);
    EXPECT_TRUE(motion.complete) << motion.message;
    for (const double swing : {0.0, 0.5}) {
      for (const double height : {0.97527711, -0.42968076}) {
        const double first = down(height) + swing;
        const double last = 0.75 - down(height) + swing;
        const auto begins = [&](const MotionBranch& branch) {
          return std::abs(branch.begins - first) < 1e-7;
        };
        const auto ends = [&](const MotionBranch& branch) {
          return std::abs(branch.ends - last) < 1e-7;
        };
        EXPECT_EQ(std::count_if(motion.branches.begin(), motion.branches.end(), begins), 2)
            << first << ", seed " << seed;
        EXPECT_EQ(std::count_if(motion.branches.begin(), motion.branches.end(), ends), 2)
            << last << ", seed " << seed;
      }
    }
  }
}

// Assembled within a thousandth of a second of t = 0.4; the law bends there too sharply for complex
// closures to be followed.
TEST(ASharplyBentSlide, HasTheBranchesThatNoCheckpointShows) {
  const MotionResult motion = motion_for_a_second(
      test::slider_crank_links(1, 1, 0) +
          "[[driver]]\nslide = \"guide\"\nvalue = \"1.999 + sqrt((t - 0.4)^2 + 1e-8)\"\n",
      1);
  EXPECT_TRUE(motion.complete) << motion.message;
  ASSERT_EQ(motion.branches.size(), 2U);
  for (const MotionBranch& branch : motion.branches) {
    EXPECT_NEAR(branch.begins, 0.4 - 0.001, 1e-5);
    EXPECT_NEAR(branch.ends, 0.4 + 0.001, 1e-5);
  }
}

}  // namespace
}  // namespace moivre
