// SPDX-License-Identifier: MIT
// Is the page whole, small, closed to the network and to names that try to break out of it?
#include "moivre/closure_report/page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "mechanisms.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/closure_report/motion_report.h"
#include "moivre/mechanism/pose.h"
#include "well_formed.h"

namespace moivre {
namespace {

using Json = nlohmann::json;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

MotionResult motion_of(const Mechanism& mechanism, int steps = 24) {
  MotionOptions options;
  options.to = natural_duration(mechanism);
  options.steps = steps;
  options.solve.threads = 1;
  return find_motion(mechanism, *make_cvode_tracker(), options);
}

/// What the page's script reads.
Json data_of(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

/// The markup without the texts of style and script, which have rules of their own.
std::string without_scripts(std::string page) {
  for (const std::string name : {"script", "style"}) {
    for (std::size_t at = 0; (at = page.find("<" + name, at)) != std::string::npos; ++at) {
      const std::size_t begin = page.find('>', at) + 1;
      page.erase(begin, page.find("</" + name + ">", begin) - begin);
    }
  }
  return page;
}

TEST(Page, HasAPanelForEachBranch) {
  const Mechanism mechanism = mechanism_file("slider-crank");
  const MotionResult motion = motion_of(mechanism);
  const std::string page = motion_html(motion, mechanism, "file");
  ASSERT_EQ(motion.branches.size(), 6U);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(count(page, "id=\"panel-" + std::to_string(k) + '"'), 1U);
  EXPECT_EQ(data_of(page)["branches"].size(), 6U);
}

TEST(Page, NamesTheCircuitOfEachBranchWhereSeveralAreOne) {
  const Mechanism mechanism = mechanism_file("stephenson-3");
  const std::string page = motion_html(motion_of(mechanism), mechanism, "file");
  for (const char* caption : {"A</b><small>circuit 1</small>", "B</b><small>circuit 2</small>",
                              "C</b><small>circuit 3</small>", "F</b><small>circuit 3</small>"}) {
    EXPECT_EQ(count(page, caption), 1U) << caption;
  }
  const Json branches = data_of(page)["branches"];
  EXPECT_EQ(branches[2]["colour"], branches[3]["colour"]);
  EXPECT_NE(branches[2]["dashes"], branches[3]["dashes"]) << "a dead point lies between";
  EXPECT_NE(branches[0]["colour"], branches[1]["colour"]);
  const Mechanism four_bar = mechanism_file("four-bar");
  EXPECT_EQ(count(motion_html(motion_of(four_bar), four_bar, "file"), "<small>"), 0U);
}

TEST(Page, PutsEachFrameWhereItsBodyIs) {
  const Mechanism mechanism = mechanism_file("four-bar");
  const MotionResult motion = motion_of(mechanism);
  const Json data = data_of(motion_html(motion, mechanism, "file"));
  const Json& frames = data["branches"][0]["frames"];
  ASSERT_EQ(frames.size(), motion.branches[0].samples.size());
  // Frames 0..3 are ground, crank, coupler, rocker; a frame is (cos, -sin, x, y) in pixels, y
  // downwards.
  const double pixels_per_mm =
      (frames[0][4 * 3 + 2].get<double>() - frames[0][2].get<double>()) / 100;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Eigen::VectorXd& q = motion.branches[0].samples[k].q;
    EXPECT_NEAR(frames[k][4 * 2].get<double>(), std::cos(q[5]), 1e-5);
    EXPECT_NEAR(frames[k][4 * 2 + 1].get<double>(), -std::sin(q[5]), 1e-5);
    const double x =
        (frames[k][4 * 2 + 2].get<double>() - frames[k][2].get<double>()) / pixels_per_mm;
    const double y =
        (frames[k][3].get<double>() - frames[k][4 * 2 + 3].get<double>()) / pixels_per_mm;
    EXPECT_NEAR(x, q[3], 1e-2);
    EXPECT_NEAR(y, q[4], 1e-2);
  }
}

TEST(Page, PlotsPositionVelocityAndAccelerationWithTheirUnits) {
  const Mechanism mechanism = mechanism_file("four-bar");
  const MotionResult motion = motion_of(mechanism);
  const Json data = data_of(motion_html(motion, mechanism, "file"));
  std::size_t rocker = 0;
  while (data["quantities"].at(rocker)["name"] != "rocker.phi") ++rocker;
  EXPECT_EQ(data["quantities"][rocker]["units"], Json::array({"deg", "deg/s", "deg/s\u00b2"}));
  EXPECT_EQ(data["quantities"][0]["name"], "coupler.P x");
  EXPECT_EQ(data["quantities"][0]["units"], Json::array({"mm", "mm/s", "mm/s\u00b2"}));
  const BranchSample& sample = motion.branches[0].samples[3];
  const Json& series = data["branches"][0]["series"][rocker];
  const double degrees = 180 / M_PI;
  EXPECT_NEAR(series[0][3].get<double>(), sample.q[8] * degrees, 1e-4);
  EXPECT_NEAR(series[1][3].get<double>() / (sample.velocity[8] * degrees), 1, 1e-6);
  EXPECT_NEAR(series[2][3].get<double>() / (sample.acceleration[8] * degrees), 1, 1e-6);
}

TEST(Page, AnEventHasAPositionAndNoVelocity) {
  const Mechanism mechanism = mechanism_file("slider-crank");
  const Json data = data_of(motion_html(motion_of(mechanism), mechanism, "file"));
  const Json& branch = data["branches"][0];
  EXPECT_NEAR(branch["t"].back().get<double>(), (36.8698976458 - 30) / 57.29577951308232, 1e-9);
  EXPECT_FALSE(branch["series"][0][0].back().is_null());
  EXPECT_TRUE(branch["series"][0][1].back().is_null());
  EXPECT_EQ(branch["ends"], "ended at t = 0.1199 s (crank = 36.869898 deg): dead point");
}

TEST(Page, OfAnglesHasNoJumpOfAWholeTurn) {
  const Mechanism mechanism = mechanism_file("slider-crank-equations");
  const Json data = data_of(motion_html(motion_of(mechanism), mechanism, "file"));
  for (const Json& branch : data["branches"]) {
    const Json& phi2 = branch["series"][1][0];
    for (std::size_t k = 1; k < phi2.size(); ++k) {
      EXPECT_LT(std::abs(phi2[k].get<double>() - phi2[k - 1].get<double>()), 180);
    }
  }
}

TEST(Page, ClosuresThatStandStillHaveNoSlider) {
  const Mechanism mechanism = mechanism_file("3-rpr");
  const std::string page = closures_html(closures_of(mechanism), mechanism, "file");
  EXPECT_EQ(count(page, "<figure"), 6U);
  EXPECT_EQ(count(page, "id=\"time\""), 0U);
  EXPECT_EQ(count(page, "6 complex closures, 6 real"), 1U);
}

TEST(Page, WithoutAnyClosureSaysSo) {
  const Mechanism mechanism = mechanism_file("unassemblable-triangle");
  const std::string page = closures_html(closures_of(mechanism), mechanism, "file");
  EXPECT_EQ(count(page, "<figure"), 0U);
  EXPECT_GE(count(page, "cannot be assembled"), 1U);
}

TEST(Page, LoadsNothingFromElsewhere) {
  const Mechanism mechanism = mechanism_file("four-bar");
  const std::string page = motion_html(motion_of(mechanism), mechanism, "file");
  EXPECT_EQ(count(page, "default-src 'none'"), 1U);
  EXPECT_EQ(count(page, "src="), 0U);
  EXPECT_EQ(count(page, "href="), 0U);
  EXPECT_EQ(count(page, "url("), 1U) << "the clip path of the plots";
  EXPECT_EQ(count(page, "http"), 2U) << "SVG's name, and http-equiv";
}

TEST(Page, NoNameBreaksOutOfMarkupOrData) {
  const std::string evil =
      "</script></style></select><script>evil()</script>\"' &amp; <!--\xFF\xE2\x80\xA8";
  Mechanism mechanism = mechanism_file("four-bar");
  mechanism.title = evil;
  mechanism.units.length = evil;
  mechanism.guess.clear();  // it names bodies
  for (Body& body : mechanism.bodies) {
    // Names of one thing are different, and the ground keeps its own.
    const auto own = [&](const auto& all, const auto& one) {
      return evil + std::to_string(&one - all.data());
    };
    if (&body != mechanism.bodies.data()) body.name = own(mechanism.bodies, body);
    for (BodyPoint& point : body.points) point.name = own(body.points, point);
  }
  for (Driver& driver : mechanism.drivers)
    driver.name = evil + std::to_string(&driver - mechanism.drivers.data());
  const MotionResult motion = motion_of(mechanism, 4);
  const std::string page = motion_html(motion, mechanism, evil);
  const test::Markup markup(without_scripts(
      page.substr(page.find("<body"), page.find("</body>") - page.find("<body") + 7)));
  EXPECT_TRUE(markup.is_well_formed());
  EXPECT_EQ(std::count(markup.elements().begin(), markup.elements().end(), "script"), 3);
  EXPECT_EQ(count(page, "<script>evil"), 0U);
  EXPECT_EQ(count(page, "<!--"), 0U);
  EXPECT_EQ(data_of(page)["drivers"][0]["name"].get<std::string>().substr(0, 9), "</script>");
}

TEST(MotionPicture, HasACurveForEachBranchAndTracedPoint) {
  const Mechanism mechanism = mechanism_file("four-bar");
  const std::string svg = motion_svg(motion_of(mechanism), mechanism, "file");
  EXPECT_TRUE(test::Markup(svg).is_well_formed());
  EXPECT_EQ(count(svg, "class=\"curve"), 4U) << "two curves, and two lines of the legend";
  EXPECT_EQ(count(svg, "Curves of coupler.P in 2 branches"), 1U);
}

TEST(MotionPicture, MarksDeadPointsAndNamesThem) {
  const Mechanism mechanism = mechanism_file("slider-crank");
  const std::string svg = motion_svg(motion_of(mechanism), mechanism, "file");
  // Two points on six branches, with an event at one end (A, B, E, F) or at both (C, D); and the
  // legend's.
  EXPECT_EQ(count(svg, "class=\"event\""), 2U * 8 + 1);
  EXPECT_EQ(count(svg, "A: crank = 30 deg to crank = 36.869898 deg (dead point)"), 1U);
}

TEST(MotionPicture, WrapsALegendThatIsWiderThanThePicture) {
  Mechanism mechanism = mechanism_file("slider-crank");
  mechanism.bodies[1].name = "crank of the second press on the left side of the hall";
  const std::string svg = motion_svg(motion_of(mechanism), mechanism, "file");
  const std::regex note("class=\"note\">([^<]*)<");
  const auto end = std::sregex_iterator();
  ASSERT_NE(std::sregex_iterator(svg.begin(), svg.end(), note), end);
  for (auto text = std::sregex_iterator(svg.begin(), svg.end(), note); text != end; ++text) {
    EXPECT_LE((*text)[1].length(), 100) << (*text)[1];
  }
  EXPECT_EQ(count(svg, "(dead point)"), 8U);
}

TEST(MotionPicture, NamesTheCircuitOfEachBranchInItsLegend) {
  const Mechanism mechanism = mechanism_file("stephenson-3");
  const std::string svg = motion_svg(motion_of(mechanism), mechanism, "file");
  EXPECT_EQ(count(svg, "; circuit 1<"), 1U);
  EXPECT_EQ(count(svg, "; circuit 3<"), 4U);
}

/// The crank's pin goes the same way in both branches, the slide of each has a way of its own.
TEST(MotionPicture, BranchesThatShareACurveAreStripesInsideEachOther) {
  const Mechanism mechanism = mechanism_file("whitworth");
  const std::string svg = motion_svg(motion_of(mechanism), mechanism, "file");
  EXPECT_TRUE(test::Markup(svg).is_well_formed());
  // Of two points, and in the legend: the wide line, a white one on it, the narrow line.
  EXPECT_EQ(count(svg, "style=\"stroke-width:6.8px\""), 3U);
  EXPECT_EQ(count(svg, "style=\"stroke:#fff;stroke-width:4.3px\""), 3U);
  EXPECT_EQ(count(svg, "style=\"stroke-width:1.8px\""), 3U);
  EXPECT_EQ(count(svg, "several branches on one curve"), 1U);
  const Mechanism four_bar = mechanism_file("four-bar");
  EXPECT_EQ(
      count(motion_svg(motion_of(four_bar), four_bar, "file"), "stroke:#fff;stroke-width:4.3"), 0U);
}

TEST(MotionTable, HasNoVelocityWhereTheConstraintsDetermineNone) {
  const Mechanism mechanism = mechanism_file("four-bar");
  MotionResult motion = motion_of(mechanism);
  motion.branches[0].samples[0].is_determined = false;
  const std::string csv = motion_csv(motion, mechanism);
  const std::size_t row = csv.find("\nA,0,") + 1;
  // The crank's x, y and angle, each without velocity and acceleration.
  EXPECT_EQ(csv.substr(row, csv.find('\n', row) - row).find("0.6981317007977318,0,,,0,,,"), 4U);
}

TEST(MotionPicture, OfTypedEquationsPlotsEachUnknownOverTheTime) {
  const Mechanism mechanism = mechanism_file("slider-crank-equations");
  const MotionResult motion = motion_of(mechanism);
  const std::string svg = motion_svg(motion, mechanism, "file");
  EXPECT_TRUE(test::Markup(svg).is_well_formed());
  EXPECT_EQ(count(svg, "<rect class=\"axis\""), mechanism.unknowns.size());
  for (const Unknown& unknown : mechanism.unknowns) EXPECT_GE(count(svg, '>' + unknown.name), 1U);
  // A curve of each branch in each plot and one in the legend, and there two stripes for shared
  // curves.
  EXPECT_EQ(count(svg, "several branches on one curve"), 1U);
  EXPECT_EQ(count(svg, "<path class=\"curve "),
            motion.branches.size() * (mechanism.unknowns.size() + 1) + 2);
}

TEST(MotionPicture, NoNameBreaksOutOfIt) {
  Mechanism mechanism = mechanism_file("four-bar");
  mechanism.title = "</title></svg><script>evil()</script>";
  mechanism.bodies[2].points[2].name = "<P>&";
  const std::string svg = motion_svg(motion_of(mechanism), mechanism, "file");
  EXPECT_TRUE(test::Markup(svg).is_well_formed());
  EXPECT_EQ(count(svg, "<script"), 0U);
}

}  // namespace
}  // namespace moivre
