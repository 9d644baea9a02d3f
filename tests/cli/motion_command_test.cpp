// SPDX-License-Identifier: MIT
// Does `moivre motion` keep its contract: branches, events, tables, refusals, interruption?
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

/// A crank of 3 and a rocker of 2 on a ground of 4, a rod of 3 between them: dead where the crank
/// stands at 90 degrees.
constexpr const char* kCrank = R"([units]
angle = "deg"
[ground.points]
O = [0, 0]
P = [4, 0]
[body.crank.points]
O = [0, 0]
A = [3, 0]
[body.rocker.points]
P = [0, 0]
B = [2, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "revolute"
at = ["ground.P", "rocker.P"]
[[joint]]
type = "rod"
at = ["crank.A", "rocker.B"]
length = 3
[[driver]]
angle = "crank"
start = 60
velocity = 60
[guess]
"rocker.phi" = 80
)";

constexpr const char* kTranscendental = R"([unknowns]
angles = ["phi"]
lengths = ["x"]
[equations]
spiral = "x - 0.3*phi"
[[driver]]
unknown = "phi"
start = 0.1
velocity = 1
)";

TEST(MotionCommand, TellsBranchesAndWhereTheyEnd) {
  Scene scene;
  scene.write("crank.toml", kCrank);
  const Outcome outcome = scene.run({"motion", "crank.toml", "--to", "1", "--json", "motion.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(has_line(outcome.out, "dead point at t = 0.5 s (crank = 90 deg): A, B end"))
      << outcome.out;
  const Json motion = Json::parse(scene.read("motion.json"));
  ASSERT_EQ(motion["branches"].size(), 2U);
  for (const Json& branch : motion["branches"]) {
    EXPECT_EQ(branch["begins"], 0);
    EXPECT_EQ(branch["begin_event"], nullptr);
    EXPECT_NEAR(branch["ends"], 0.5, 1e-9);
    EXPECT_EQ(motion["events"][branch["end_event"].get<std::size_t>()]["kind"], "dead point");
  }
}

TEST(MotionCommand, GoesRoundOnceByDefault) {
  Scene scene;
  scene.write("crank.toml", kCrank);
  const Outcome outcome = scene.run({"motion", "crank.toml", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_NEAR(json["to"].get<double>(), 6, 1e-12);
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(json["events"].size(), 3U);
  EXPECT_EQ(json["branches"].size(), 6U);
}

/// The table, cell by column name, a row a line.
std::vector<std::map<std::string, std::string>> table_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const auto cells = [](const std::string& text) {
    std::vector<std::string> all;
    std::istringstream stream(text);
    for (std::string cell; std::getline(stream, cell, ',');) all.push_back(cell);
    return all;
  };
  const std::vector<std::string> names = cells(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> row = cells(line);
    EXPECT_EQ(row.size(), names.size());
    rows.emplace_back();
    for (std::size_t k = 0; k < names.size(); ++k) rows.back()[names[k]] = row[k];
  }
  return rows;
}

TEST(MotionCommand, TableAndJsonSayTheSame) {
  Scene scene;
  scene.write("crank.toml", kCrank);
  const Outcome outcome = scene.run({"motion", "crank.toml", "--to", "0.4", "--steps", "4",
                                     "--json", "m.json", "--csv", "m.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(scene.read("m.json"));
  const auto rows = table_of(scene.read("m.csv"));
  ASSERT_EQ(rows.size(), 10U);
  std::size_t k = 0;
  for (const Json& branch : json["branches"]) {
    for (const Json& sample : branch["samples"]) {
      const auto& row = rows.at(k++);
      const auto cell = [&](const char* name) {
        return std::strtod(row.at(name).c_str(), nullptr);
      };
      EXPECT_EQ(row.at("branch"), branch["id"].get<std::string>());
      EXPECT_EQ(cell("t"), sample["t"]);
      EXPECT_EQ(cell("driver crank [rad]"), sample["drivers"][0]);
      EXPECT_EQ(cell("rocker.phi [rad]"), sample["coordinates"]["rocker.phi"]);
      EXPECT_EQ(cell("rocker.phi.velocity [rad/s]"), sample["velocities"]["rocker.phi"]);
      EXPECT_EQ(cell("rocker.phi.acceleration [rad/s^2]"), sample["accelerations"]["rocker.phi"]);
      EXPECT_EQ(cell("rocker.B.y"), sample["points"]["rocker.B"]["position"][1]);
      EXPECT_EQ(cell("rocker.B.x.velocity"), sample["points"]["rocker.B"]["velocity"][0]);
      EXPECT_EQ(cell("rocker.B.y.acceleration"), sample["points"]["rocker.B"]["acceleration"][1]);
    }
  }
}

/// A crank-rocker driven at its rocker: the closures of one side meet in dead points.
constexpr const char* kRocker = R"([units]
angle = "deg"
[ground.points]
O = [0, 0]
P = [6, 0]
[body.rocker.points]
O = [0, 0]
A = [5, 0]
[body.crank.points]
P = [0, 0]
B = [2, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "rocker.O"]
[[joint]]
type = "revolute"
at = ["ground.P", "crank.P"]
[[joint]]
type = "rod"
at = ["rocker.A", "crank.B"]
length = 7
name = "coupler"
[[driver]]
angle = "rocker"
start = 90
velocity = 60
)";

TEST(MotionCommand, TellsHowFarTheDriverRocksFromWhereItBegins) {
  Scene scene;
  scene.write("crank.toml", kCrank);
  // Dead at 90 and at -90 degrees; the crank begins at 60.
  const Outcome outcome = scene.run({"motion", "crank.toml"});
  EXPECT_TRUE(contains(outcome.out, "crank rocks -90 .. 90 deg between dead points"))
      << outcome.out;
}

TEST(MotionCommand, TellsDriversThatStandOnceAndBodiesThatDoNotTurn) {
  Scene scene;
  scene.write("table.toml", R"([units]
angle = "deg"
[ground.points]
O = [0, 0]
[body.x.points]
O = [0, 0]
[body.y.points]
O = [0, 0]
[[joint]]
type = "prismatic"
at = ["ground.O", "x.O"]
along = [1, 0]
name = "right"
[[joint]]
type = "prismatic"
at = ["x.O", "y.O"]
along = [0, 1]
name = "up"
[[driver]]
slide = "right"
start = 0
velocity = 1
[[driver]]
slide = "up"
start = 5
)");
  const Outcome outcome = scene.run({"motion", "table.toml", "--to", "1"});
  EXPECT_TRUE(contains(outcome.out, "from t = 0 s (right = 0, up = 5) to t = 1 s (right = 1)"))
      << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "branch A: from t = 0 s (right = 0)\n")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "x does not turn; y does not turn")) << outcome.out;
}

TEST(MotionCommand, TellsCircuitsPairsAndFourBars) {
  Scene scene;
  scene.write("rocker.toml", kRocker);
  const Outcome outcome = scene.run({"motion", "rocker.toml", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["full_turn"], true);
  ASSERT_EQ(json["circuits"].size(), 2U);
  const Json& circuit = json["circuits"][0];
  EXPECT_EQ(circuit["driver"], "rocks");
  EXPECT_EQ(circuit["stretches"].size(), 2U);
  EXPECT_EQ(circuit["dead_points"].size(), 2U);
  EXPECT_EQ(circuit["bodies"][1]["name"], "crank");
  EXPECT_EQ(circuit["bodies"][1]["turns"], 1);
  ASSERT_EQ(json["pairs"].size(), 1U);
  EXPECT_EQ(json["pairs"][0]["closures"], Json::array({"A", "B"}));
  EXPECT_EQ(json["pairs"][0]["dead_points"], 1);
  ASSERT_EQ(json["four_bars"].size(), 1U);
  EXPECT_EQ(json["four_bars"][0]["letters"], "GRRC");
  EXPECT_EQ(json["four_bars"][0]["links"], Json::array({"ground", "rocker", "coupler", "crank"}));
}

TEST(MotionCommand, JsonOfMoreBranchesThanAreListedHasNoPairsOfTheWhole) {
  const Scene scene;
  const std::string beest =
      MOIVRE_SOURCE_DIR "/problems/people/strandbeest-4-drawn-pose-not-listed.toml";
  const Outcome outcome = scene.run({"motion", beest, "--tracker", "lanes", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["all_listed"], false);
  EXPECT_TRUE(report["pairs"].empty());
}

TEST(MotionCommand, ClosureLeavesWhatIsReachedFromIt) {
  Scene scene;
  scene.write("rocker.toml", kRocker);
  const Outcome outcome =
      scene.run({"motion", "rocker.toml", "--closure", "B", "--json", "-", "--csv", "b.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["circuits"].size(), 1U);
  EXPECT_EQ(json["branches"].size(), json["circuits"][0]["branches"].size());
  EXPECT_EQ(json["checkpoints"][0]["branches"], Json::array({"A", "B"}));
  for (const auto& row : table_of(scene.read("b.csv"))) {
    const Json& ids = json["circuits"][0]["branches"];
    EXPECT_NE(std::find(ids.begin(), ids.end(), row.at("branch")), ids.end());
  }
}

TEST(MotionCommand, UnknownClosureIsRefusedWithThoseThatThereAre) {
  Scene scene;
  scene.write("rocker.toml", kRocker);
  const Outcome outcome =
      scene.run({"motion", "rocker.toml", "--closure", "D", "--closure", "A", "--csv", "d.csv"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err,
            "moivre: there is no closure 'D' where the motion begins; there are A, B\n");
  EXPECT_FALSE(scene.has("d.csv"));
}

TEST(MotionCommand, FollowsOneGuessWithoutPolynomials) {
  Scene scene;
  scene.write("crank.toml", kCrank);
  for (const std::vector<std::string>& choice :
       {std::vector<std::string>{"--from-guess"}, {"--guess", "rocker.phi=-170"}}) {
    std::vector<std::string> words{"motion", "crank.toml", "--to", "0.25", "--json", "-"};
    words.insert(words.end(), choice.begin(), choice.end());
    const Outcome outcome = scene.run(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json["branches"].size(), 1U);
    EXPECT_EQ(json["paths"]["tracked"], 0);
    EXPECT_TRUE(json["tracker"].is_null());
    const double phi = json["branches"][0]["samples"][0]["coordinates"]["rocker.phi"];
    EXPECT_NEAR(phi, choice.size() == 1 ? 1.354165 : -2.963433, 1e-6);
  }
}

TEST(MotionCommand, TakesByGuessWhatHasNoClosurePolynomials) {
  Scene scene;
  scene.write("spiral.toml", kTranscendental);
  const Outcome refused = scene.run({"motion", "spiral.toml", "--to", "2"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(refused.err,
            "moivre: equation spiral is no polynomial: the angle phi stands outside cos and sin; "
            "newton, mobility and motion take it as it is\n"
            "One pose can be followed without closures: --from-guess takes the one that "
            "Newton-Raphson assembles.\n");
  const Outcome taken =
      scene.run({"motion", "spiral.toml", "--to", "2", "--from-guess", "--json", "-"});
  ASSERT_EQ(taken.exit_code, 0) << taken.err;
  const Json last = Json::parse(taken.out)["branches"][0]["samples"].back();
  EXPECT_NEAR(last["coordinates"]["x"].get<double>(), 0.3 * 2.1, 1e-14);
  EXPECT_NEAR(last["velocities"]["x"].get<double>(), 0.3, 1e-14);
}

TEST(MotionCommand, WrongCallsAreRefusedWithoutOutput) {
  Scene scene;
  scene.write("crank.toml", kCrank);
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--from", "2", "--to", "1"},
        {"--from", "1", "--to", "1"},
        {"--to", "inf"},
        {"--from", "-1e308", "--to", "1e308"},
        {"--to", "1e9"},
        {"--steps", "0"},
        {"--steps", "1000000000"},
        {"--checkpoints", "-1"},
        {"--checkpoints", "2000000"},
        {"--guess", "rocker.phi=1e300"},
        {"--guess", "rocker.fi=3"},
        {"--steps", "many"}}) {
    std::vector<std::string> words{"motion", "crank.toml"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const Outcome outcome = scene.run(words);
    EXPECT_EQ(outcome.exit_code, 1) << wrong[0];
    EXPECT_EQ(outcome.out, "") << wrong[0];
    EXPECT_NE(outcome.err, "") << wrong[0];
  }
}

TEST(MotionCommand, GuessThatDoesNotAssembleIsUndecided) {
  Scene scene;
  std::string apart = kCrank;
  apart.replace(apart.find("length = 3"), 10, "length = 30");
  scene.write("apart.toml", apart);
  const Outcome outcome = scene.run({"motion", "apart.toml", "--from-guess", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 2);
  const Json motion = Json::parse(outcome.out);
  EXPECT_EQ(motion["complete"], false);
  EXPECT_EQ(motion["failures"].size(), 1U);
  EXPECT_TRUE(motion["branches"].empty());
  EXPECT_EQ(scene.run({"motion", "apart.toml"}).exit_code, 0);
}

TEST(MotionCommand, InterruptEndsItWithWhatIsFinished) {
  Scene scene;
  scene.write("crank.toml", kCrank);
  const Outcome outcome = scene.run(
      {"motion", "crank.toml", "--checkpoints", "100000", "--json", "-"}, false, [](int process) {
        EXPECT_TRUE(catches_interrupt(process));
        ::kill(process, SIGINT);
      });
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["complete"], false);
}

TEST(MotionCommand, HelpShowsExamples) {
  const Scene scene;
  const Outcome outcome = scene.run({"motion", "--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(contains(outcome.out, "moivre motion four-bar.toml")) << outcome.out;
}

}  // namespace
}  // namespace moivre::test
