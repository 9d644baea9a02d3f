// SPDX-License-Identifier: MIT
// Does `moivre closures --sensitivity` keep its contract: text, table, JSON, tolerances, dead
// points, spare constraints, refusals?
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "refusing.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

std::string mechanism(const std::string& name) {
  return std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/" + name + ".toml";
}

Json json_of(const Scene& scene, std::vector<std::string> words) {
  words.insert(words.begin(), "closures");
  words.insert(words.end(), {"--quiet", "--json", "-"});
  const Outcome outcome = scene.run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return Json::parse(outcome.out);
}

std::size_t number_of(const Json& result, const std::string& dimension) {
  const Json& all = result["dimensions"];
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Json& one) { return one["name"] == dimension; });
  return static_cast<std::size_t>(found - all.begin());
}

/// Two links of 1 to a slider whose place the driver gives: a dead point at 2.
std::string toggle(const std::string& start) {
  return "tolerance = 0.01\n[ground.points]\nG = [0, 0]\n[body.a.points]\nG = [0, 0]\nM = [1, 0]\n"
         "[body.b.points]\nM = [0, 0]\nS = [1, 0]\n[body.slider.points]\nS = [0, 0]\n"
         "[[joint]]\ntype = \"revolute\"\nat = [\"ground.G\", \"a.G\"]\n"
         "[[joint]]\ntype = \"revolute\"\nat = [\"a.M\", \"b.M\"]\n"
         "[[joint]]\ntype = \"revolute\"\nat = [\"b.S\", \"slider.S\"]\n"
         "[[joint]]\ntype = \"prismatic\"\nat = [\"ground.G\", \"slider.S\"]\nalong = [1, 0]\n"
         "name = \"guide\"\n[[driver]]\nslide = \"guide\"\nstart = " +
         start + "\n";
}

TEST(SensitivityCommand, TellsRatesAndSpreadsInJson) {
  const Scene scene;
  const Json result =
      json_of(scene, {mechanism("four-bar"), "--sensitivity", "--tolerance", "0.05"});
  const std::size_t k = number_of(result, "rocker.B.x");
  ASSERT_LT(k, result["dimensions"].size());
  EXPECT_EQ(result["dimensions"][k]["kind"], "length");
  EXPECT_EQ(result["dimensions"][k]["value"], 80);
  EXPECT_EQ(result["dimensions"][k]["tolerance"], 0.05);
  EXPECT_EQ(result["dimensions"][number_of(result, "crank")]["kind"], "angle");
  EXPECT_EQ(result["dimensions"][number_of(result, "crank")]["tolerance"], 0);
  for (const Json& closure : result["closures"]) {
    const Json& told = closure["sensitivity"];
    EXPECT_EQ(told["determined"], true);
    EXPECT_TRUE(told["cannot_change_alone"].empty());
    ASSERT_EQ(told["points"]["coupler.P"].size(), 2U);
    double sum = 0, squares = 0;
    for (std::size_t d = 0; d < result["dimensions"].size(); ++d) {
      const double share = told["points"]["coupler.P"][0]["rates"][d].get<double>() *
                           result["dimensions"][d]["tolerance"].get<double>();
      sum += std::abs(share);
      squares += share * share;
    }
    EXPECT_NEAR(told["points"]["coupler.P"][0]["worst_case"].get<double>(), sum, 1e-12);
    EXPECT_NEAR(told["points"]["coupler.P"][0]["root_sum_square"].get<double>(), std::sqrt(squares),
                1e-12);
    EXPECT_EQ(told["coordinates"]["crank.phi"]["rates"].size(), result["dimensions"].size());
    EXPECT_TRUE(told["joints"].contains("A"));
  }
}

TEST(SensitivityCommand, IsNotToldUnlessAsked) {
  const Scene scene;
  const Json result = json_of(scene, {mechanism("four-bar")});
  EXPECT_FALSE(result.contains("dimensions"));
  EXPECT_FALSE(result["closures"][0].contains("sensitivity"));
  const Json exact = json_of(scene, {mechanism("four-bar"), "--sensitivity"});
  EXPECT_FALSE(
      exact["closures"][0]["sensitivity"]["points"]["coupler.P"][0].contains("worst_case"));
}

TEST(SensitivityCommand, ShowsPeopleTheMostInfluentialDimensionsFirst) {
  const Scene scene;
  const Outcome outcome =
      scene.run({"closures", mechanism("four-bar"), "--sensitivity", "--tolerance", "0.05"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"\nsensitivity of closure A, by a change of 1 mm or 1 deg\n  coupler.P",
                           "tolerance 0.05 mm", "worst case, up or down", "root sum square",
                           "angles and slides", "\nsensitivity of closure B"}) {
    EXPECT_TRUE(contains(outcome.out, part)) << part << '\n' << outcome.out;
  }
  const std::size_t first = outcome.out.find("\n    coupler.A.x  ");
  EXPECT_LT(first, outcome.out.find("\n    ground.O2.x  "));
  EXPECT_NE(first, std::string::npos);
}

TEST(SensitivityCommand, WritesOneLinePerClosureAndDimension) {
  const Scene scene;
  const Outcome outcome = scene.run({"closures", mechanism("four-bar"), "--sensitivity", "--quiet",
                                     "--tolerance", "0.05", "--angles", "deg", "--csv", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string head, line;
  std::getline(lines, head);
  EXPECT_EQ(head,
            "id,dimension,unit,value,tolerance,crank.x,crank.y,crank.phi "
            "[deg],coupler.x,coupler.y,coupler.phi [deg],rocker.x,rocker.y,rocker.phi "
            "[deg],crank.O2.x,crank.O2.y,crank.A.x,crank.A.y,coupler.A.x,coupler.A.y,coupler.B.x,"
            "coupler.B.y,coupler.P.x,coupler.P.y,rocker.O4.x,rocker.O4.y,rocker.B.x,rocker.B.y,"
            "joint O2 [deg],joint A [deg],joint B [deg],joint O4 [deg]");
  const auto commas = std::count(head.begin(), head.end(), ',');
  std::size_t spreads = 0;
  bool has_driver = false;
  for (std::size_t k = 0; std::getline(lines, line); ++k) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
    spreads += line.find(",worst case,") != std::string::npos ? 1 : 0;
    if (line.rfind("A,crank,deg,40,0,0,0,", 0) != 0) continue;
    // The crank's own angle goes with the driver, a degree by a degree.
    has_driver = true;
    EXPECT_NEAR(std::stod(line.substr(21)), 1, 1e-12) << line;
  }
  EXPECT_EQ(spreads, 2U);
  EXPECT_TRUE(has_driver) << outcome.out;
}

TEST(SensitivityCommand, HasNullsAtADeadPoint) {
  const Scene scene;
  scene.write("dead.toml", toggle("2"));
  const Json result = json_of(scene, {"dead.toml", "--sensitivity"});
  ASSERT_EQ(result["closures"].size(), 1U);
  const Json& told = result["closures"][0]["sensitivity"];
  EXPECT_EQ(told["determined"], false);
  EXPECT_EQ(told["message"], "it is a dead point, where sensitivities have no bound");
  EXPECT_TRUE(told["points"]["a.M"][1]["rates"][number_of(result, "guide")].is_null());
  EXPECT_TRUE(told["points"]["a.M"][1]["worst_case"].is_null());
  const Outcome text = scene.run({"closures", "dead.toml", "--sensitivity"});
  EXPECT_TRUE(has_line(
      text.out,
      "sensitivity of closure A: none; it is a dead point, where sensitivities have no bound"))
      << text.out;
  EXPECT_FALSE(contains(text.out, "nan")) << text.out;
}

TEST(SensitivityCommand, NamesWhatCannotChangeAlone) {
  const Scene scene;
  const Json result =
      json_of(scene, {mechanism("double-parallel-crank"), "--sensitivity", "--tolerance", "0.1"});
  const Json& told = result["closures"][0]["sensitivity"];
  EXPECT_EQ(told["determined"], true);
  const std::size_t k = number_of(result, "crank1.A1.x");
  EXPECT_NE(std::find(told["cannot_change_alone"].begin(), told["cannot_change_alone"].end(),
                      "crank1.A1.x"),
            told["cannot_change_alone"].end());
  EXPECT_TRUE(told["coordinates"]["coupler.x"]["rates"][k].is_null());
  EXPECT_TRUE(told["coordinates"]["coupler.x"]["worst_case"].is_null());
  const Outcome text = scene.run({"closures", mechanism("double-parallel-crank"), "--sensitivity"});
  EXPECT_TRUE(contains(text.out, "cannot change alone, the mechanism would not close: ground.O1.x"))
      << text.out;
}

TEST(SensitivityCommand, TakesTolerancesOfTheFileAndOneForTheRest) {
  const Scene scene;
  scene.write("near.toml", "title = \"near\"\n" + toggle("1.5\ntolerance = 0.25") +
                               "[body.a.tolerances]\nM = [0.125, 0.5]\n");
  const auto tolerance = [&](const Json& result, const char* name) {
    return result["dimensions"][number_of(result, name)]["tolerance"].get<double>();
  };
  const Json typed = json_of(scene, {"near.toml", "--sensitivity"});
  EXPECT_EQ(tolerance(typed, "a.M.x"), 0.125);
  EXPECT_EQ(tolerance(typed, "a.M.y"), 0.5);
  EXPECT_EQ(tolerance(typed, "guide"), 0.25);
  EXPECT_EQ(tolerance(typed, "b.S.x"), 0.01);
  EXPECT_EQ(tolerance(typed, "guide.turn"), 0);
  const Json other = json_of(scene, {"near.toml", "--sensitivity", "--tolerance", "0.03"});
  EXPECT_EQ(tolerance(other, "a.M.x"), 0.125);
  EXPECT_EQ(tolerance(other, "b.S.x"), 0.03);
}

TEST(SensitivityCommand, SaysWhereNoClosureIsIsolated) {
  const Scene scene;
  std::string text = toggle("1.5");
  scene.write("loose.toml", text.substr(0, text.find("[[driver]]")));
  const Outcome outcome = scene.run({"closures", "loose.toml", "--sensitivity"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has_line(outcome.out, "sensitivity: none, as no closure is isolated")) << outcome.out;
}

using RefusedSensitivity = RefusingCommands;

TEST_F(RefusedSensitivity, NamesEveryFault) {
  scene.write("near.toml", toggle("1.5"));
  expect_refusal({"closures", "near.toml", "--sensitivity", "--tolerance", "-1"},
                 {"--tolerance of dimensions must be a length from 0 up"});
  expect_refusal({"closures", "near.toml", "--sensitivity", "--tolerance", "wide"},
                 {"--tolerance"});
  expect_refusal({"closures", "near.toml", "--tolerance", "0.1"}, {"--tolerance"});
  expect_refusal({"closures", mechanism("slider-crank-equations"), "--sensitivity"},
                 {"typed equations have no dimensions to vary"});
  expect_refusal({"closures", "near.toml", "--sensitivty"}, {"--sensitivity"});
  scene.write("wide.toml", "[body.a.tolerances]\nN = 0.1\n" + toggle("1.5"));
  expect_refusal({"closures", "wide.toml"}, {"body 'a' has no point 'N'", "wide.toml:2:1"});
}

}  // namespace
}  // namespace moivre::test
