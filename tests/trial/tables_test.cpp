// SPDX-License-Identifier: MIT
// Do tables and pictures say what their numbers are? Units of angles, angles that go on, pitch
// circles, endings of files.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "files.h"

namespace moivre::test {
namespace {

using Table = std::map<std::string, std::vector<std::string>>;

Table table_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::vector<std::string> names;
  Table table;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::size_t k = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++k) {
      if (table.size() <= k && names.size() <= k) {
        names.push_back(cell);
        table[cell];
      } else {
        table[names.at(k)].push_back(cell);
      }
    }
  }
  return table;
}

Table motion_of(const std::string& name, std::vector<std::string> options) {
  options.insert(options.end(), {"--quiet", "--csv", "-"});
  return table_of(tried("motion", name, options).out);
}

TEST(TableOfAMotion, NamesTheUnitOfAnglesAndTakesDegrees) {
  const Table radians = motion_of("roller", {"--steps", "4"});
  ASSERT_EQ(radians.count("crank.phi [rad]"), 1U);
  ASSERT_EQ(radians.count("crank.phi.velocity [rad/s]"), 1U);
  ASSERT_EQ(radians.count("driver crank [rad]"), 1U);
  ASSERT_EQ(radians.count("crank.x"), 1U);
  const Table degrees = motion_of("roller", {"--steps", "4", "--angles", "deg"});
  ASSERT_EQ(degrees.count("crank.phi [deg]"), 1U);
  EXPECT_NEAR(std::stod(degrees.at("crank.phi [deg]").at(0)), 40, 1e-9);
  EXPECT_NEAR(std::stod(radians.at("crank.phi [rad]").at(0)), 40 * std::acos(-1.0) / 180, 1e-12);
  EXPECT_NEAR(std::stod(degrees.at("crank.phi.velocity [deg/s]").at(0)), 1432.3944878270581, 1e-6);
  EXPECT_EQ(degrees.at("rocker.B.x"), radians.at("rocker.B.x"));
}

TEST(TableOfAMotion, LetsAnglesGoOnWhereThatIsAskedFor) {
  const auto largest_jump = [](const Table& table) {
    double jump = 0;
    const auto& phi = table.at("crank.phi [deg]");
    const auto& branch = table.at("branch");
    for (std::size_t k = 1; k < phi.size(); ++k) {
      if (branch[k] == branch[k - 1])
        jump = std::max(jump, std::abs(std::stod(phi[k]) - std::stod(phi[k - 1])));
    }
    return jump;
  };
  EXPECT_GT(largest_jump(motion_of("roller", {"--steps", "36", "--angles", "deg"})), 300);
  EXPECT_LT(largest_jump(motion_of("roller", {"--steps", "36", "--angles", "deg", "--continuous"})),
            15);
}

TEST(TableOfAMotion, BeginsADrivenAngleAtItsDriversValueInLaterBranchesToo) {
  const Table table = motion_of("eightbar", {"--steps", "60", "--angles", "deg", "--continuous"});
  ASSERT_EQ(table.at("branch").back(), "F");  // it begins at 296 degrees
  for (std::size_t k = 0; k < table.at("branch").size(); ++k) {
    EXPECT_NEAR(std::stod(table.at("crank.phi [deg]")[k]),
                std::stod(table.at("driver crank [deg]")[k]), 1e-9);
  }
}

TEST(TablesOfPoses, NameTheUnitOfAngles) {
  for (const std::string command : {"closures", "guesses", "newton"}) {
    const Table degrees =
        table_of(tried(command, "roller", {"--quiet", "--csv", "-", "--angles", "deg"}).out);
    ASSERT_EQ(degrees.count("crank.phi [deg]"), 1U) << command;
    EXPECT_NEAR(std::stod(degrees.at("crank.phi [deg]").back()), 40, 1e-9) << command;
  }
  EXPECT_EQ(answered("closures", "roller").json.at("units").at("angle"), "rad");
  EXPECT_EQ(tried("closures", "roller", {"--angles", "grad"}).exit_code, 1);
}

TEST(Picture, IsRefusedUnderTheNameOfAnotherFormat) {
  const Outcome png = tried("closures", "roller", {"--svg", "out.png"});
  EXPECT_EQ(png.exit_code, 1);
  EXPECT_EQ(png.err, "moivre: --svg writes svg, not png: out.svg would be its name\n");
  EXPECT_EQ(tried("motion", "roller", {"--html", "page.pdf"}).exit_code, 1);
}

TEST(PictureOfPlanetaryGears, HasAPitchCircleForEveryWheel) {
  for (const std::string name : {"planetary", "diff"}) {
    const Outcome outcome = tried("closures", name, {"--quiet", "--svg", "-"});
    EXPECT_TRUE(contains(outcome.out, "class=\"pitch-circle")) << name;
  }
}

TEST(DriversOfOnePoint, AreToldApart) {
  Scene scene;
  scene.write("point.toml", R"([ground.points]
O = [0, 0]
[body.upper.points]
O = [0, 0]
A = [3, 0]
[body.lower.points]
A = [0, 0]
P = [2, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "upper.O"]
[[joint]]
type = "revolute"
at = ["upper.A", "lower.A"]
[[driver]]
x = "lower.P"
start = 3
velocity = 0.1
[[driver]]
y = "lower.P"
start = 2
)");
  const Outcome motion =
      scene.run({"motion", "point.toml", "--steps", "2", "--csv", "-", "--quiet"});
  EXPECT_TRUE(motion.out.starts_with("branch,t,driver lower.P.x,driver lower.P.y,upper.x,"))
      << motion.out.substr(0, 99);
}

}  // namespace
}  // namespace moivre::test
