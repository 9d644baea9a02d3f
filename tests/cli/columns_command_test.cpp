// SPDX-License-Identifier: MIT
// Do --columns and --output of `moivre motion` keep their contract: table, extremes, JSON, the
// page, refusals?
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

const std::string kNorton = std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
const std::string kGuide = std::string(MOIVRE_SOURCE_DIR) + "/docs/guide/quick-return.toml";

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST(Columns, ReplaceThoseOfTheTable) {
  const Scene scene;
  const Outcome outcome =
      scene.run({"motion", kNorton, "--quiet", "--steps", "4", "--csv", "-", "--angles", "deg",
                 "--columns", "transmission, advantage,singularity"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(first_line(outcome.out),
            "branch,t,driver crank [deg],coupler-rocker transmission [deg],crank-rocker advantage "
            "[-],distance to singularity [-]");
  std::istringstream row(outcome.out.substr(outcome.out.find("\nA,0,") + 1));
  std::vector<std::string> cells;
  for (std::string cell; cells.size() < 5 && std::getline(row, cell, ',');) cells.push_back(cell);
  EXPECT_NEAR(std::stod(cells[3]), 37.02699, 1e-4);
  EXPECT_NEAR(std::stod(cells[4]), 3.57246, 1e-4);
}

TEST(Columns, LeaveTheDefaultTableAlone) {
  const Scene scene;
  const Outcome outcome = scene.run({"motion", kNorton, "--quiet", "--steps", "2", "--csv", "-"});
  EXPECT_EQ(first_line(outcome.out).substr(0, 40), "branch,t,driver crank [rad],crank.x,cran");
}

TEST(Columns, LetAnglesThatTurnGoOnOnlyWhereThatIsAskedFor) {
  const Scene scene;
  const auto last_angle = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"motion",    kNorton,  "--quiet",  "--csv", "-",
                                   "--columns", "joints", "--angles", "deg"};
    words.insert(words.end(), more.begin(), more.end());
    const std::string csv = scene.run(words).out;
    const std::size_t line = csv.rfind("\nA,");
    std::istringstream row(csv.substr(line + 1));
    std::string cell;
    for (int k = 0; k < 4; ++k) std::getline(row, cell, ',');
    return std::stod(cell);
  };
  EXPECT_NEAR(last_angle({}), 40, 1e-6);
  EXPECT_NEAR(last_angle({"--continuous"}), 400, 1e-6);
}

TEST(Columns, TellNoRoundingForAnExtremeOrItsPlace) {
  const Scene scene;
  const std::string parallelogram = MOIVRE_SOURCE_DIR "/problems/mechanisms/parallelogram.toml";
  const Outcome text = scene.run({"motion", parallelogram, "--columns", "transmission"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_TRUE(contains(text.out, "  0 at crank = ")) << text.out;
  EXPECT_FALSE(contains(text.out, "e-")) << text.out;
}

TEST(Columns, TellTheirExtremesAsTextAndJson) {
  const Scene scene;
  const Outcome text = scene.run({"motion", kGuide, "--columns", "transmission"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_TRUE(has_line(text.out, "extremes of branch B")) << text.out;
  EXPECT_TRUE(contains(text.out, "link-ram transmission [deg]")) << text.out;
  EXPECT_TRUE(contains(text.out, "time ratio of guide: ")) << text.out;
  const Outcome outcome = scene.run({"motion", kGuide, "--columns", "transmission", "--output",
                                     "rocker", "--quiet", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json["columns"].size(), 2U);
  EXPECT_EQ(json["columns"][0]["name"], "coupler-rocker transmission");
  EXPECT_EQ(json["columns"][0]["unit"], "rad");
  const Json& branch = json["branches"][1];
  EXPECT_EQ(branch["samples"][0]["columns"].size(), 2U);
  const Json& least = branch["extremes"]["coupler-rocker transmission"]["least"];
  EXPECT_FALSE(least["unbounded"]);
  for (const Json& sample : branch["samples"]) {
    EXPECT_LE(least["value"].get<double>(), sample["columns"][0].get<double>());
  }
  ASSERT_EQ(branch["time_ratios"].size(), 1U);
  EXPECT_EQ(branch["time_ratios"][0]["output"], "rocker");
  EXPECT_GT(branch["time_ratios"][0]["ratio"].get<double>(), 1);
}

TEST(Columns, AreListedForWhoAsksOrMisspells) {
  const Scene scene;
  const Outcome help = scene.run({"motion", kNorton, "--columns", "help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* group : {"joints", "coefficients", "transmission", "advantage", "singularity",
                            "coordinates", "points", "all"}) {
    EXPECT_TRUE(contains(help.out, std::string("\n  ") + group + " ")) << group;
  }
  const Outcome wrong = scene.run({"motion", kNorton, "--columns", "jonts"});
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_EQ(wrong.out, "");
  EXPECT_TRUE(wrong.err.starts_with(
      "moivre: --columns: there is no group 'jonts'; did you mean 'joints'?\n"))
      << wrong.err;
  EXPECT_TRUE(
      has_line(wrong.err,
               "  singularity   smallest singular value of the scaled Jacobian, 0 at a dead point"))
      << wrong.err;
  const Outcome output =
      scene.run({"motion", kNorton, "--columns", "advantage", "--output", "roker"});
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_EQ(
      output.err,
      "moivre: there is no output 'roker': it is a body (its angle, or its slide where it cannot "
      "turn), a joint, or a point's coordinate such as rocker.B.x; did you mean 'rocker'?\n");
  EXPECT_EQ(scene.run({"motion", kNorton, "--output", "rocker"}).exit_code, 1);
}

TEST(Columns, CanBePlottedOnThePage) {
  const Scene scene;
  const Outcome outcome = scene.run({"motion", kNorton, "--quiet", "--steps", "6", "--columns",
                                     "joints,transmission", "--html", "page.html"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = scene.read("page.html");
  EXPECT_TRUE(contains(page, ">coupler-rocker transmission</option>"));
  EXPECT_TRUE(
      contains(page, "{\"name\":\"joint B\",\"units\":[\"deg\",\"deg/s\",\"deg/s\u00b2\"]}"));
  EXPECT_TRUE(contains(page, "Save all as CSV"));
}

}  // namespace
}  // namespace moivre::test
