// SPDX-License-Identifier: MIT
// Have mechanisms with every type of spatial joint as many closures as geometry says, and those
// with joints taken apart the same?
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mechanisms.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

struct Joined {
  std::string what;
  std::string text;
  std::uint64_t complex;
};

std::string points(const std::string& body, const std::vector<std::string>& at) {
  std::string text = body == "ground" ? "[ground.points]\n" : "[body." + body + ".points]\n";
  for (std::size_t k = 0; k < at.size(); ++k) {
    text += "P" + std::to_string(k) + " = [" + at[k] + "]\n";
  }
  return text;
}

std::string joint(const std::string& type, const std::string& ends, const std::string& rest = "") {
  return "[[joint]]\ntype = \"" + type + "\"\nat = [" + ends + "]\n" + rest + "\n";
}

const std::string kSpatial = "space = \"spatial\"\n";

/// Turns about axes in general position, from the ground to the tip of the last link.
std::string links(std::size_t count) {
  const std::vector<std::string> axes{"[[0, 0, 1], [0, 0, 1]]", "[[0, 0.6, 0.8], [1, 0, 0.2]]",
                                      "[[0.3, 1, 0], [0.1, 0.5, 1]]"};
  std::string text = kSpatial + points("ground", {"0, 0, 0", "0.9, 0.3, 0.4"});
  for (std::size_t k = 0; k < count; ++k) {
    text += points("b" + std::to_string(k), {"0, 0, 0", "1, 0.2, 0.1"});
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::string before = k == 0 ? "ground.P0" : "b" + std::to_string(k - 1) + ".P1";
    text += joint("revolute", "\"" + before + "\", \"b" + std::to_string(k) + ".P0\"",
                  "axis = " + axes[k]);
  }
  return text;
}

std::string plate(const std::string& type, std::size_t count) {
  const std::vector<std::string> there{"1, 0.1, 0.2",   "-0.3, 1, 0.4", "0.2, -0.8, 1",
                                       "-1, -0.4, 0.3", "0.6, 0.7, -1", "-0.5, 0.3, 0.9"};
  const std::vector<std::string> here{"0.9, 0.2, 0",   "-0.2, 0.8, 0.1", "0.3, -0.7, 0.2",
                                      "-0.8, -0.3, 0", "0.5, 0.6, -0.3", "-0.4, 0.2, 0.5"};
  const std::vector<std::string> axes{"1, 2, 3",  "-1, 0.5, 2",   "0.3, 1, 0.1",
                                      "2, -1, 1", "0.2, 0.4, -1", "1, 1, -0.7"};
  std::string text =
      kSpatial +
      points("ground", {there.begin(), there.begin() + static_cast<std::ptrdiff_t>(count)}) +
      points("plate", {here.begin(), here.begin() + static_cast<std::ptrdiff_t>(count)});
  for (std::size_t k = 0; k < count; ++k) {
    const std::string n = std::to_string(k);
    text += joint(type, "\"ground.P" + n + "\", \"plate.P" + n + "\"", "axis = [" + axes[k] + "]");
  }
  return text;
}

class EveryJointType : public testing::TestWithParam<Joined> {};

TEST_P(EveryJointType, HasAsManyClosuresAsGeometrySays) {
  const Mechanism mechanism = mechanism_text(GetParam().text);
  const Phi phi(mechanism);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const ClosureResult result = closures_of(mechanism, seed);
    EXPECT_TRUE(result.complete) << result.message;
    EXPECT_EQ(result.counts.complex, GetParam().complex) << "seed " << seed;
    for (const Closure& closure : result.closures) {
      EXPECT_LE(scaled_residual(phi, closure.q, 0), 1e-12);
    }
  }
}

// An arm of three turns reaches a point in 4 ways; a line meets a torus in 4 points, a plane a
// circle in 2. Points on planes are linear in the nine entries of R and the shift: three quadrics
// in P^3 are left. Three points on lines are three distances.
INSTANTIATE_TEST_SUITE_P(
    Spatial, EveryJointType,
    testing::Values(Joined{"AnArmHeldByItsTip",
                           links(3) + joint("spherical", "\"ground.P1\", \"b2.P1\""), 4},
                    Joined{"ALineThroughATorus",
                           links(2) + joint("point-on-line", "\"ground.P1\", \"b1.P1\"",
                                            "axis = [0.2, 1, 0.3]"),
                           4},
                    Joined{"ACircleThroughAPlane",
                           links(1) + joint("point-on-plane", "\"ground.P1\", \"b0.P1\"",
                                            "axis = [1, 0.2, 0.3]"),
                           2},
                    Joined{"APlateOnSixPlanes", plate("point-on-plane", 6), 8},
                    Joined{"APlateOnThreeLines", plate("point-on-line", 3), 8}),
    [](const auto& tested) { return tested.param.what; });

/// The place of point P1 of body b0, in every closure.
std::vector<Eigen::Vector3d> tips(const Mechanism& mechanism, const ClosureResult& result) {
  std::vector<Eigen::Vector3d> places;
  for (const Closure& closure : result.closures) {
    places.push_back(point_position(mechanism, {1, 1}, closure.q));
  }
  return places;
}

TEST(APlanarJoint, HasTheClosuresOfTwoSlidesAndATurn) {
  const std::string bodies = kSpatial + points("ground", {"0, 0, 0", "0.9, 0.3, 0.4"}) +
                             points("b0", {"0.1, 0.2, 0.3", "1, 0.4, 0.2"}) +
                             points("b1", {"0, 0.1, 0", "0.7, 0.3, 0.5"}) +
                             points("b2", {"0.2, 0, 0", "0.4, 0.8, 0.1"});
  const std::string rest =
      joint("revolute", "\"b0.P1\", \"b1.P0\"", "axis = [[1, 0.2, 0], [0, 0.3, 1]]") +
      joint("revolute", "\"b1.P1\", \"b2.P0\"", "axis = [[0.1, 1, 0.4], [1, 0, 0.2]]") +
      joint("revolute", "\"b2.P1\", \"ground.P1\"", "axis = [[0.3, 0.1, 1], [0, 1, 0.5]]");
  const Mechanism whole = mechanism_text(
      bodies + joint("planar", "\"ground.P0\", \"b0.P0\"", "axis = [0, 0, 1]") + rest);
  const Mechanism apart =
      mechanism_text(bodies + "[body.m0.points]\nO = [0, 0, 0]\n[body.m1.points]\nO = [0, 0, 0]\n" +
                     joint("prismatic", "\"ground.P0\", \"m0.O\"", "axis = [1, 0, 0]") +
                     joint("prismatic", "\"m0.O\", \"m1.O\"", "axis = [0, 1, 0]") +
                     joint("revolute", "\"m1.O\", \"b0.P0\"", "axis = [0, 0, 1]") + rest);
  const ClosureResult of_whole = closures_of(whole);
  const ClosureResult of_apart = closures_of(apart);
  EXPECT_TRUE(of_whole.complete && of_apart.complete);
  EXPECT_GE(of_whole.counts.complex, 4U);
  EXPECT_EQ(of_whole.counts.complex, of_apart.counts.complex);
  const auto there = tips(apart, of_apart);
  for (const Eigen::Vector3d& tip : tips(whole, of_whole)) {
    EXPECT_TRUE(std::any_of(there.begin(), there.end(), [&](const Eigen::Vector3d& other) {
      return (other - tip).norm() < 1e-9;
    }));
  }
}

/// A loop of six joints in general position, those in `slides` prismatic.
std::string loop_of_six(std::size_t first, std::size_t second) {
  const std::vector<std::string> axes{
      "[[0, 0.6, 0.8], [1, 0, 0.2]]", "[[0.3, 1, 0], [0.1, 0.5, 1]]", "[[1, 0, 0.4], [0.2, 1, 0]]",
      "[[0, 0.2, 1], [1, 0.7, 0]]",   "[[0.5, 0.5, 1], [0, 1, 0.1]]", "[[1, 0.3, 0], [0.4, 0, 1]]"};
  std::string text = kSpatial + points("ground", {"0, 0, 0", "0.4, 0.9, 0.2"});
  for (std::size_t k = 0; k + 1 < axes.size(); ++k) {
    text += points("b" + std::to_string(k), {"0, 0.1, 0", "0.8, 0.2, 0." + std::to_string(k)});
  }
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const bool is_last = k + 1 == axes.size();
    const std::string before = k == 0 ? "ground.P0" : "b" + std::to_string(k - 1) + ".P1";
    const std::string next = is_last ? "ground.P1" : "b" + std::to_string(k) + ".P0";
    text += joint(k == first || k == second ? "prismatic" : "revolute",
                  "\"" + before + "\", \"" + next + "\"", "axis = " + axes[k]);
  }
  return text;
}

TEST(FourTurnsAndTwoSlides, HaveEightClosuresWhereverTheSlidesAre) {
  for (std::size_t first = 0; first < 6; ++first) {
    for (std::size_t second = first + 1; second < 6; ++second) {
      SCOPED_TRACE("slides " + std::to_string(first) + " and " + std::to_string(second));
      const Mechanism mechanism = mechanism_text(loop_of_six(first, second));
      const ClosureResult result = closures_of(mechanism);
      EXPECT_TRUE(result.complete) << result.message;
      EXPECT_EQ(result.counts.complex, 8U);
      const bool are_beside = second == first + 1 || (first == 0 && second == 5);
      EXPECT_EQ(result.paths.tracked, are_beside ? 8U : 16U);
      for (const Closure& closure : result.closures) {
        EXPECT_LE(scaled_residual(Phi(mechanism), closure.q, 0), 1e-12);
      }
    }
  }
}

/// A jack in a loop of six turns: its angle is driven.
std::string jack(const std::string& type, const std::string& rest) {
  std::string text = kSpatial + points("ground", {"0, 0, 0", "0.4, 0.9, 0.2"});
  const std::vector<std::string> axes{
      "[[0, 0.6, 0.8], [1, 0, 0.2]]", "[[0.3, 1, 0], [0.1, 0.5, 1]]", "[[1, 0, 0.4], [0.2, 1, 0]]",
      "[[0, 0.2, 1], [1, 0.7, 0]]",   "[[0.5, 0.5, 1], [0, 1, 0.1]]", "[[1, 0.3, 0], [0.4, 0, 1]]"};
  for (std::size_t k = 0; k < axes.size(); ++k) {
    text += points("b" + std::to_string(k), {"0, 0.1, 0", "0.8, 0.2, 0." + std::to_string(k)});
  }
  text += joint(type, "\"ground.P0\", \"b0.P0\"", "axis = [0, 0, 1]\nname = \"jack\"\n" + rest);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const std::string next =
        k + 1 < axes.size() ? "b" + std::to_string(k + 1) + ".P0" : "ground.P1";
    text += joint("revolute", "\"b" + std::to_string(k) + ".P1\", \"" + next + "\"",
                  "axis = " + axes[k]);
  }
  return text + "[[driver]]\nangle = \"jack\"\nstart = 7.5\n";
}

TEST(ADrivenScrew, HasTheClosuresOfASleeveThatIsDrivenBothWays) {
  const double slide = 7.5 * 0.3 / (2 * std::numbers::pi);
  const ClosureResult screw = closures_of(mechanism_text(jack("screw", "pitch = 0.3")));
  const Mechanism sleeve = mechanism_text(
      jack("cylindrical", "") + "[[driver]]\nslide = \"jack\"\nvalue = \"7.5*0.3/(2*pi)\"\n");
  const ClosureResult other = closures_of(sleeve);
  EXPECT_TRUE(screw.complete) << screw.message;
  EXPECT_EQ(screw.counts.complex, 16U);
  ASSERT_EQ(screw.closures.size(), other.closures.size());
  ASSERT_FALSE(screw.closures.empty());
  for (std::size_t k = 0; k < screw.closures.size(); ++k) {
    EXPECT_LE((screw.closures[k].q - other.closures[k].q).norm(), 1e-9);
    EXPECT_NEAR(joint_coordinate(sleeve, sleeve.joints[0], screw.closures[k].q).value(), slide,
                1e-12);
  }
}

TEST(AScrewThatIsNotDriven, IsRefusedBeforeAnyTracking) {
  const std::string text = kSpatial + points("ground", {"0, 0, 0"}) + points("nut", {"0, 0, 0"}) +
                           joint("screw", "\"ground.P0\", \"nut.P0\"",
                                 "axis = [0, 0, 1]\npitch = 0.5\nname = \"thread\"");
  try {
    closures_of(mechanism_text(text));
    FAIL();
  } catch (const std::invalid_argument& refusal) {
    EXPECT_EQ(std::string(refusal.what()),
              "the screw 'thread' ties an angle to a length, which no polynomial says; drive it "
              "(slide = \"thread\"), or follow one pose with `follow_guesses`");
  }
}

}  // namespace
}  // namespace moivre
