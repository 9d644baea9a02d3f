// SPDX-License-Identifier: MIT
// Do the figures stand where the poses put the mechanism, and does each joint have its symbol?
#include "moivre/closure_report/drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mechanisms.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

constexpr double kRounding = 1e-12;  // of places, lengths being about 10

/// All shapes of a style, placed in the ground frame.
std::vector<Shape> placed(const Drawing& drawing, const std::vector<Similarity>& places,
                          Style style) {
  std::vector<Shape> found;
  for (const Figure& figure : drawing.figures) {
    for (Shape shape : figure.shapes) {
      if (shape.style != style) continue;
      for (Complex& z : shape.points) z = places[figure.frame](z);
      found.push_back(shape);
    }
  }
  return found;
}

struct Scene {
  Mechanism mechanism;
  std::vector<Eigen::VectorXd> poses;
  Drawing drawing;

  explicit Scene(Mechanism given) : mechanism(std::move(given)) {
    for (const Closure& closure : closures_of(mechanism).closures) poses.push_back(closure.q);
    drawing = draw(mechanism, poses);
  }
  std::vector<Shape> in_pose(std::size_t k, Style style) const {
    return placed(drawing, place(drawing, mechanism, poses[k]), style);
  }
  Complex point(std::size_t pose, std::size_t body, std::size_t k) const {
    return seen(mechanism, point_position(mechanism, {body, k}, poses[pose]));
  }
};

bool has_point_near(const Shape& shape, Complex z) {
  return std::any_of(shape.points.begin(), shape.points.end(),
                     [&](Complex point) { return std::abs(point - z) < kRounding * 1e3; });
}

TEST(Drawing, ALinkHasItsPointsWhereThePoseSays) {
  const Scene scene(mechanism_file("four-bar"));
  ASSERT_EQ(scene.poses.size(), 2U);
  for (std::size_t pose = 0; pose < 2; ++pose) {
    const std::vector<Shape> links = scene.in_pose(pose, Style::link);
    ASSERT_EQ(links.size(), 3U);
    for (std::size_t body = 1; body <= 3; ++body) {
      const std::size_t points = scene.mechanism.bodies[body].points.size();
      EXPECT_EQ(links[body - 1].points.size(), points);
      for (std::size_t k = 0; k < points; ++k) {
        EXPECT_TRUE(has_point_near(links[body - 1], scene.point(pose, body, k)));
      }
    }
  }
}

TEST(Drawing, ALinkIsTheConvexHullOfItsPoints) {
  const Mechanism plate = mechanism_text(R"(
[ground.points]
O = [0, 0]
[body.plate.points]
O = [0, 0]
E = [4, 0]
M = [2, 0]
C = [2, 1]
T = [2, 4]
[[joint]]
type = "revolute"
at = ["ground.O", "plate.O"]
[[driver]]
angle = "plate"
start = 0
velocity = 1
)");
  const Scene scene(plate);
  const std::vector<Shape> links = scene.in_pose(0, Style::link);
  ASSERT_EQ(links.size(), 1U);
  EXPECT_EQ(links[0].points.size(), 3U) << "M and C are no corners";
}

TEST(Drawing, APinStandsOnBothOfItsPoints) {
  const Scene scene(mechanism_file("four-bar"));
  const std::vector<Shape> pins = scene.in_pose(0, Style::pin);
  EXPECT_EQ(pins.size(), 2 * scene.mechanism.joints.size());
  for (std::size_t k = 0; k + 1 < pins.size(); k += 2) {
    EXPECT_NEAR(std::abs(pins[k].points[0] - pins[k + 1].points[0]), 0, kRounding * 1e3);
  }
}

TEST(Drawing, TheGroundIsHatchedOnceBelowEachOfItsPivots) {
  const Scene scene(mechanism_file("jansen-leg"));  // two joints at P
  const std::vector<Shape> ground = scene.in_pose(0, Style::ground);
  EXPECT_EQ(std::count_if(ground.begin(), ground.end(), [](const Shape& s) { return s.is_closed; }),
            2);
  EXPECT_GE(scene.in_pose(0, Style::hatch).size(), 4U);
}

TEST(Drawing, AGuideReachesItsSliderInEveryPose) {
  const Scene scene(mechanism_file("slider-crank"));
  ASSERT_EQ(scene.poses.size(), 2U);
  for (std::size_t pose = 0; pose < 2; ++pose) {
    const Complex slider = scene.point(pose, 3, 0);
    const std::vector<Shape> guides = scene.in_pose(pose, Style::guide);
    ASSERT_EQ(guides.size(), 1U);
    EXPECT_LT(guides[0].points[0].real(), slider.real());
    EXPECT_GT(guides[0].points[1].real(), slider.real());
    const std::vector<Shape> blocks = scene.in_pose(pose, Style::block);
    ASSERT_EQ(blocks.size(), 1U);
    EXPECT_NEAR(std::abs((blocks[0].points[0] + blocks[0].points[2]) / 2.0 - slider), 0,
                kRounding * 1e3);
  }
}

TEST(Drawing, ASliderOnAMovingLeverTurnsWithIt) {
  const Scene scene(mechanism_file("inverted-slider-crank"));
  for (std::size_t pose = 0; pose < scene.poses.size(); ++pose) {
    const Shape block = scene.in_pose(pose, Style::block).at(0);
    const Shape guide = scene.in_pose(pose, Style::guide).at(0);
    const Complex along_block = block.points[1] - block.points[0];
    const Complex along_guide = guide.points[1] - guide.points[0];
    const double sine = std::imag(std::conj(along_block) * along_guide) /
                        (std::abs(along_block) * std::abs(along_guide));
    EXPECT_NEAR(sine, 0, kRounding * 1e3);
  }
}

TEST(Drawing, ASlotHoldsItsPinInEveryPose) {
  for (const char* file : {"scotch-yoke", "whitworth"}) {
    const Scene scene(mechanism_file(file));
    for (std::size_t pose = 0; pose < scene.poses.size(); ++pose) {
      const Shape slot = scene.in_pose(pose, Style::slot).at(0);
      const Complex pin = scene.in_pose(pose, Style::slot_pin).at(0).points[0];
      const Complex along = slot.points[1] - slot.points[0];
      const Complex place = (pin - slot.points[0]) / along;
      EXPECT_GT(place.real(), 0) << file;
      EXPECT_LT(place.real(), 1) << file;
      EXPECT_NEAR(place.imag(), 0, kRounding * 1e3) << file;
    }
  }
}

TEST(Drawing, ARodReachesFromPointToPoint) {
  const Scene scene(mechanism_file("3-rpr"));
  for (std::size_t pose = 0; pose < scene.poses.size(); ++pose) {
    const std::vector<Shape> rods = scene.in_pose(pose, Style::rod);
    ASSERT_EQ(rods.size(), 3U);
    for (std::size_t leg = 0; leg < 3; ++leg) {
      EXPECT_TRUE(has_point_near(rods[leg], scene.point(pose, 0, leg)));
      EXPECT_TRUE(has_point_near(rods[leg], scene.point(pose, 1, leg)));
    }
  }
}

TEST(Drawing, PitchCirclesOfAnOutsideMeshTouchBetweenTheWheels) {
  const Scene scene(mechanism_file("gear-five-bar"));  // 20 and 40 teeth, 4 apart
  const std::vector<Shape> circles = scene.in_pose(0, Style::pitch_circle);
  ASSERT_EQ(circles.size(), 2U);
  EXPECT_NEAR(circles[0].radius, 4.0 / 3, kRounding);
  EXPECT_NEAR(circles[1].radius, 8.0 / 3, kRounding);
  EXPECT_NEAR(std::abs(circles[0].points[0] - circles[1].points[0]), 4, kRounding);
}

TEST(Drawing, PitchCirclesOfAnInsideMeshTouchBeyondTheSmallerWheel) {
  const Scene scene(mechanism_text(R"(
[ground.points]
O1 = [0, 0]
O2 = [4, 0]
[body.pinion.points]
O1 = [0, 0]
A = [1, 0]
[body.ring.points]
O2 = [0, 0]
B = [1, 0]
[[joint]]
type = "revolute"
at = ["ground.O1", "pinion.O1"]
[[joint]]
type = "revolute"
at = ["ground.O2", "ring.O2"]
[[joint]]
type = "gear"
bodies = ["pinion", "ring"]
ratio = [20, 60]
[[driver]]
angle = "pinion"
start = 0
velocity = 1
)"));
  const std::vector<Shape> circles = scene.in_pose(0, Style::pitch_circle);
  ASSERT_EQ(circles.size(), 2U);
  EXPECT_NEAR(circles[0].radius, 2, kRounding);
  EXPECT_NEAR(circles[1].radius, 6, kRounding);
}

TEST(Drawing, ACamsPitchCurveRunsThroughItsFollowersPoint) {
  for (const double angle : {0.0, 1.0, 2.0, 4.0}) {
    const Scene scene(driven_from(mechanism_file("cam-valve"), angle));
    const std::vector<Shape> links = scene.in_pose(0, Style::link);
    const auto curve = std::find_if(links.begin(), links.end(),
                                    [](const Shape& shape) { return !shape.is_closed; });
    ASSERT_NE(curve, links.end());
    const Complex roller = scene.point(0, 2, 0);
    double nearest = 1e9;
    for (const Complex z : curve->points) nearest = std::min(nearest, std::abs(z - roller));
    EXPECT_LT(nearest, 0.6);  // its points are 2 degrees apart at a radius of up to 28
    EXPECT_NEAR(std::abs(curve->points.front() - curve->points.back()), 0, kRounding);
  }
}

TEST(Drawing, ACrossedBeltIsTangentToBothPulleysAndCrosses) {
  const Scene scene(mechanism_file("belt-five-bar"));
  const std::vector<Shape> circles = scene.in_pose(0, Style::pitch_circle);
  ASSERT_EQ(circles.size(), 2U);
  EXPECT_NEAR(circles[0].radius, 1.1, kRounding);
  EXPECT_NEAR(circles[1].radius, 0.55, kRounding);
  std::vector<Shape> tangents = scene.in_pose(0, Style::mark);
  std::erase_if(tangents, [](const Shape& shape) { return shape.is_closed; });
  ASSERT_EQ(tangents.size(), 2U);
  for (const Shape& tangent : tangents) {
    const Complex along = tangent.points[1] - tangent.points[0];
    for (std::size_t end = 0; end < 2; ++end) {
      const Complex spoke = tangent.points[end] - circles[end].points[0];
      EXPECT_NEAR(std::abs(spoke), circles[end].radius, kRounding);
      EXPECT_NEAR((std::conj(spoke) * along).real(), 0, kRounding);
    }
    EXPECT_LT(tangent.points[0].imag() * tangent.points[1].imag(), 0);
  }
}

TEST(Drawing, AnActuatorReachesFromPinToPinAndItsCylinderIsAsLongInEveryPose) {
  const Scene scene(mechanism_file("crane"));
  ASSERT_EQ(scene.poses.size(), 4U);
  for (std::size_t pose = 0; pose < 4; ++pose) {
    const std::vector<Shape> rods = scene.in_pose(pose, Style::wire);
    const std::vector<Shape> cylinders = scene.in_pose(pose, Style::rod);
    ASSERT_EQ(rods.size(), 2U);
    ASSERT_EQ(cylinders.size(), 2U);
    EXPECT_TRUE(has_point_near(rods[0], scene.point(pose, 0, 1)));
    EXPECT_TRUE(has_point_near(rods[0], scene.point(pose, 1, 1)));
    EXPECT_NEAR(std::abs(cylinders[0].points[1] - cylinders[0].points[0]), 0.6 * 1.1, kRounding);
    const Complex middle =
        (cylinders[0].points[1] + cylinders[0].points[2]) / 2.0 - scene.point(pose, 0, 1);
    const Complex line = scene.point(pose, 1, 1) - scene.point(pose, 0, 1);
    EXPECT_NEAR((std::conj(line) * middle).imag(), 0, kRounding);
  }
}

TEST(Drawing, ARackTouchesItsPinionsPitchCircle) {
  const Scene scene(mechanism_file("rack-crank"));
  ASSERT_EQ(scene.poses.size(), 2U);
  for (std::size_t pose = 0; pose < 2; ++pose) {
    const std::vector<Shape> circles = scene.in_pose(pose, Style::pitch_circle);
    ASSERT_EQ(circles.size(), 1U);
    EXPECT_NEAR(circles[0].radius, 10, kRounding);
    const Complex touching = circles[0].points[0] + Complex(0, 10);
    bool is_touched = false;
    for (const Shape& bar : scene.in_pose(pose, Style::link)) {
      const auto on_line = [&](Complex z) { return std::abs(z.imag() - touching.imag()) < 1e-9; };
      const auto ends =
          std::minmax_element(bar.points.begin(), bar.points.end(),
                              [](Complex a, Complex b) { return a.real() < b.real(); });
      is_touched = is_touched ||
                   (std::count_if(bar.points.begin(), bar.points.end(), on_line) == 2 &&
                    ends.first->real() < touching.real() && ends.second->real() > touching.real());
    }
    EXPECT_TRUE(is_touched) << "pose " << pose;
  }
}

TEST(Drawing, AWeldIsASquareWithoutAPin) {
  const Scene scene(mechanism_text(R"(
[ground.points]
O = [0, 0]
[body.crank.points]
O = [0, 0]
A = [2, 0]
[body.tail.points]
A = [0, 0]
B = [1, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "weld"
at = ["crank.A", "tail.A"]
turn = 0.5
[[driver]]
angle = "crank"
start = 0.3
velocity = 1
)"));
  EXPECT_EQ(scene.in_pose(0, Style::weld).size(), 1U);
  EXPECT_EQ(scene.in_pose(0, Style::pin).size(), 2U);
}

TEST(Drawing, ANeedleTurnsWithItsAngleAndAMarkerMovesWithItsLength) {
  const Scene scene(mechanism_file("slider-crank-equations"));
  ASSERT_EQ(scene.poses.size(), 2U);
  EXPECT_FALSE(scene.drawing.to_scale);
  std::vector<double> markers;
  for (std::size_t pose = 0; pose < 2; ++pose) {
    const std::vector<Shape> shapes = scene.in_pose(pose, Style::link);
    ASSERT_EQ(shapes.size(), 3U);
    const Complex needle = shapes[1].points[1] - shapes[1].points[0];
    const double turned = std::abs(std::arg(needle) - scene.poses[pose][1]);
    EXPECT_NEAR(std::min(turned, std::abs(turned - M_PI)), 0, 1e-9);
    markers.push_back(shapes[2].points[0].real());
  }
  EXPECT_EQ(markers[0] < markers[1], scene.poses[0][2] < scene.poses[1][2]);
}

TEST(Drawing, ASpatialBodyIsDrawnBetweenItsPointsAsTheyAreSeen) {
  const Mechanism rssr = mechanism_file("rssr");
  const Eigen::VectorXd q = initial_guess(rssr);
  const Drawing drawing = draw(rssr, {q});
  const std::vector<Shape> wires = placed(drawing, place(drawing, rssr, q), Style::wire);
  ASSERT_EQ(wires.size(), 3U) << "crank, rocker, and the coupler that is a distance";
  for (std::size_t body = 1; body <= 2; ++body) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Complex z = seen(rssr, point_position(rssr, {body, k}, q));
      EXPECT_NEAR(std::abs(wires[body - 1].points[k] - z), 0, kRounding * 1e3);
    }
  }
}

// Where the wrist flips, no point moves: the forearm turns about the line of its points.
TEST(Drawing, EveryPostureOfAPumaHasBodiesThatAreSeenElsewhere) {
  const Scene scene(mechanism_file("puma-560"));
  ASSERT_EQ(scene.poses.size(), 8U);
  for (std::size_t i = 0; i < scene.poses.size(); ++i) {
    const std::vector<Shape> bodies = scene.in_pose(i, Style::wire);
    for (std::size_t j = 0; j < i; ++j) {
      const std::vector<Shape> others = scene.in_pose(j, Style::wire);
      ASSERT_EQ(bodies.size(), others.size());
      double farthest = 0;
      for (std::size_t k = 0; k < bodies.size(); ++k) {
        for (std::size_t point = 0; point < bodies[k].points.size(); ++point) {
          farthest =
              std::max(farthest, std::abs(bodies[k].points[point] - others[k].points[point]));
        }
      }
      EXPECT_GT(farthest, 2 * scene.drawing.symbol) << i << ' ' << j;
    }
  }
}

TEST(Drawing, PointsThatAJointHoldsTogetherHaveOneLabel) {
  const Drawing drawing = Scene(mechanism_file("four-bar")).drawing;
  std::vector<std::string> names;
  for (const Label& label : drawing.labels) {
    if (label.kind == LabelKind::point) names.push_back(label.text);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"A", "B", "O2", "O4", "P"}));
}

TEST(Drawing, ItsBoxHoldsEveryShape) {
  const Scene scene(mechanism_file("watt-1"));
  const std::vector<Similarity> places = place(scene.drawing, scene.mechanism, scene.poses[0]);
  const Box box = bounds(scene.drawing, places);
  for (const Shape& pin : placed(scene.drawing, places, Style::pin)) {
    EXPECT_LE(box.lower.real(), pin.points[0].real() - pin.radius);
    EXPECT_GE(box.upper.imag(), pin.points[0].imag() + pin.radius);
  }
  EXPECT_TRUE(Box().is_empty());
}

}  // namespace
}  // namespace moivre
