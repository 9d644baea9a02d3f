// SPDX-License-Identifier: MIT
// Is the picture of all closures complete, legible and well-formed, for every mechanism of
// problems/mechanisms?
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "labels.h"
#include "mechanisms.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#include "panels.h"
#include "well_formed.h"

namespace moivre {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

std::string picture_of(const Mechanism& mechanism, const std::string& file = "file.toml") {
  return closures_svg(closures_of(mechanism), mechanism, file);
}

TEST(Picture, HasAPanelForEachClosureWithItsId) {
  const std::string svg = picture_of(mechanism_file("jansen-leg"));
  EXPECT_EQ(count(svg, "class=\"panel\""), 8U);
  for (const char id : {'A', 'B', 'C', 'D', 'E', 'F', 'G', 'H'}) {
    EXPECT_EQ(count(svg, std::string("class=\"id\">") + id + "<"), 1U) << id;
  }
}

TEST(Picture, SaysTitleCountsDriversAndScale) {
  const std::string svg = picture_of(mechanism_file("four-bar"));
  EXPECT_EQ(count(svg, ">Four-bar, Norton example 4-1</text>"), 1U);
  EXPECT_EQ(count(svg, "2 complex closures, 2 real; crank = 40 deg"), 1U);
  EXPECT_EQ(count(svg, ">20 mm</text>"), 1U);
}

TEST(Picture, OfASpatialMechanismComesFromThreeSidesInOneScale) {
  const Mechanism bennett = mechanism_file("bennett");
  const std::string svg = closures_svg(closures_of(bennett), bennett, "bennett.toml", Views::three);
  EXPECT_TRUE(test::Markup(svg).is_well_formed());
  EXPECT_EQ(count(svg, "class=\"panel\""), 3U);
  for (const char* side : {">A, front: x, z<", ">A, right: y, z<", ">A, above: x, y<"}) {
    EXPECT_EQ(count(svg, side), 1U) << side;
  }
  EXPECT_EQ(count(svg, "in the file&#39;s unit of length"), 1U);
}

// A place seen from the front and from above goes the same way to the right; from the right, the
// place's y does.
TEST(Picture, ThreeSidesShowTheCoordinatesTheyName) {
  const Mechanism bennett = mechanism_file("bennett");
  constexpr double kRightAngle = std::numbers::pi / 2;
  const Eigen::Vector3d r(2, 3, 5);
  EXPECT_LT(std::abs(seen(bennett, r, {-kRightAngle, 0}) - Complex(2, 5)), 1e-14);
  EXPECT_LT(std::abs(seen(bennett, r, {0, 0}) - Complex(3, 5)), 1e-14);
  EXPECT_LT(std::abs(seen(bennett, r, {-kRightAngle, kRightAngle}) - Complex(2, 3)), 1e-14);
}

TEST(Picture, RefusesThreeViewsOfWhatLiesInAPlane) {
  const Mechanism four_bar = mechanism_file("four-bar");
  EXPECT_THROW(closures_svg(closures_of(four_bar), four_bar, "four-bar.toml", Views::three),
               std::invalid_argument);
}

TEST(Picture, IsNamedAfterTheFileWhereThereIsNoTitle) {
  Mechanism mechanism = mechanism_file("four-bar");
  mechanism.title.clear();
  EXPECT_GE(count(picture_of(mechanism, "my.toml"), ">my.toml<"), 1U);
}

TEST(Picture, ShowsTheGuessWhereNothingCanBeAssembled) {
  const std::string svg = picture_of(mechanism_file("unassemblable-triangle"));
  EXPECT_EQ(count(svg, "no closure: the initial guess"), 1U);
  EXPECT_GE(count(svg, "cannot be assembled: every"), 1U);
  EXPECT_EQ(count(svg, "class=\"faint\""), 1U);
}

TEST(Picture, SaysWhichClosureIsSingular) {
  const Mechanism m = mechanism_file("parallelogram");
  ClosureResult result = closures_of(m);
  EXPECT_EQ(count(closures_svg(result, m, "file.toml"), "A: singular, multiplicity 2"), 1U);
  ASSERT_EQ(result.closures.size(), 1U);
  result.closures[0].cluster = true;
  EXPECT_EQ(count(closures_svg(result, m, "file.toml"), "A: singular, a cluster of 2 closures"),
            1U);
}

TEST(Picture, NoNameBreaksOutOfIt) {
  const std::string evil = "</text></svg><script>alert('x')</script>&amp;\"\xFF]]>";
  Mechanism mechanism = mechanism_file("3-rpr");
  mechanism.title = evil;
  mechanism.guess.clear();  // it names bodies
  for (Body& body : mechanism.bodies) {
    // Names of one thing are different, and the ground keeps its own.
    const auto own = [&](const auto& all, const auto& one) {
      return evil + std::to_string(&one - all.data());
    };
    if (&body != mechanism.bodies.data()) body.name = own(mechanism.bodies, body);
    for (BodyPoint& point : body.points) point.name = own(body.points, point);
  }
  for (Joint& joint : mechanism.joints)
    joint.name = evil + std::to_string(&joint - mechanism.joints.data());
  mechanism.units.length = evil;
  const std::string svg = picture_of(mechanism);
  const test::Markup markup(svg);
  EXPECT_TRUE(markup.is_well_formed());
  EXPECT_EQ(std::count(markup.elements().begin(), markup.elements().end(), "script"), 0);
}

// Which tracker finds the closures is no matter here, and there are many.
TEST(Picture, OfEveryMechanismIsWellFormed) {
  ClosureOptions options;
  options.solve.seed = 1;
  options.with_mobility = true;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(MOIVRE_SOURCE_DIR) +
                                                               "/problems/mechanisms")) {
    const std::string name = entry.path().stem().string();
    const Mechanism mechanism = mechanism_file(name);
    if (entry.path().extension() != ".toml") continue;
    const ClosureResult closures = find_closures(mechanism, *make_lane_tracker(), options);
    const std::string svg = closures_svg(closures, mechanism, "file.toml");
    EXPECT_TRUE(test::Markup(svg).is_well_formed()) << name;
    EXPECT_EQ(count(svg, "nan"), 0U) << name;
  }
}

/// Square pixels that two labels of one panel share at the most, and the frame outside which none
/// reaches.
void expect_legible(const std::string& name) {
  const Mechanism mechanism = mechanism_file(name);
  std::vector<Eigen::VectorXd> poses;
  for (const Closure& closure : closures_of(mechanism).closures) poses.push_back(closure.q);
  const Drawing drawing = draw(mechanism, poses);
  for (const Eigen::VectorXd& q : poses) {
    const std::vector<Similarity> places = place(drawing, mechanism, q);
    const PixelMap map{pixel_scale(drawing), 0};
    Box frame;
    const Box box = bounds(drawing, places);
    constexpr double kRoom = 30;
    frame.include(map(box.lower), kRoom);
    frame.include(map(box.upper), kRoom);
    const auto labels = place_labels(drawing, mechanism, q, places, map, frame);
    EXPECT_EQ(labels.size(), drawing.labels.size()) << name;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        constexpr double kSmallestFont = 11;
        const Complex d = labels[i].at - labels[j].at;
        const double half_widths = (text_width(labels[i].text, kSmallestFont) +
                                    text_width(labels[j].text, kSmallestFont)) /
                                   2;
        const bool are_apart =
            std::abs(d.imag()) > 0.6 * kSmallestFont || std::abs(d.real()) > 0.8 * half_widths;
        EXPECT_TRUE(are_apart) << name << ": " << labels[i].text << " and " << labels[j].text;
      }
      EXPECT_GT(labels[i].at.real(), frame.lower.real()) << name << ": " << labels[i].text;
      EXPECT_LT(labels[i].at.real(), frame.upper.real()) << name << ": " << labels[i].text;
    }
  }
}

TEST(Picture, LabelsLieBesideEachOther) {
  for (const char* name :
       {"four-bar", "slider-crank", "watt-1", "stephenson-3", "jansen-leg", "assur-7-serial",
        "assur-7-quaternary", "3-rpr", "whitworth", "gear-five-bar", "scotch-yoke"}) {
    expect_legible(name);
  }
}

}  // namespace
}  // namespace moivre
