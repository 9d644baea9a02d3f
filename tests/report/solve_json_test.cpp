// SPDX-License-Identifier: MIT
// Does the JSON of a solve say everything, under the names of the contract, and nothing that JSON
// cannot say?
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "hand_made_result.h"
#include "moivre/report/solve_report.h"
#include "moivre/report/version.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

Json json_of(const SolveResult& result) { return Json::parse(solve_json(result, "two.phc")); }

TEST(SolveJson, HoldsTheContractsKeysAndValues) {
  const Json json = json_of(hand_made_result());
  EXPECT_EQ(json["moivre"], std::string(version()));
  EXPECT_EQ(json["command"], "solve");
  EXPECT_EQ(json["file"], "two.phc");
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["system"],
            Json::parse(R"({"variables":["x","alpha"],"degrees":[2,3],"total_degree":6})"));
  EXPECT_EQ(json["reduced"], Json::parse(R"({"variables":2,"degrees":[2,3]})"));
  EXPECT_EQ(json["start"]["kind"], "total-degree");
  EXPECT_EQ(json["start"]["paths"], 6);
  EXPECT_EQ(
      json["paths"],
      Json::parse(R"({"tracked":6,"finite":3,"at_infinity":1,"failed":2,"not_needed":0,"by_count":0,
                                           "on_positive_dimensional":0,"retracked":4,"handed_over":0,"mixed":1,"double_double":2,"multiprecision":0})"));
  EXPECT_EQ(json["left_out"],
            Json::parse(R"([{"what":"z eliminated","why":"a linear equation gives it"}])"));
  EXPECT_EQ(json["time_s"]["threads"], 2);
  EXPECT_EQ(json["time_s"]["total"], 0.25);
  EXPECT_EQ(json["work"], Json::parse(R"({"steps":100,"rejected":10,"evaluations":50,
                                          "linearizations":40,"factorizations":30})"));
}

TEST(SolveJson, KeepsEveryBitOfACoordinate) {
  const SolveResult result = hand_made_result();
  const Json json = json_of(result);
  ASSERT_EQ(json["solutions"].size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(json["solutions"][k]["x"][i][0].get<double>(), result.solutions[k].x[i].real());
      EXPECT_EQ(json["solutions"][k]["x"][i][1].get<double>(), result.solutions[k].x[i].imag());
    }
  }
  EXPECT_EQ(json["solutions"][1]["multiplicity"], 2);
  EXPECT_EQ(json["solutions"][1]["winding"], Json::parse("[2]"));
  EXPECT_EQ(json["solutions"][1]["singular"], true);
}

TEST(SolveJson, NamesEveryFailedPathWithItsReason) {
  const Json json = json_of(hand_made_result());
  ASSERT_EQ(json["failures"].size(), 2U);
  EXPECT_EQ(json["failures"][0]["path"], 2);
  EXPECT_EQ(json["failures"][0]["reason"], to_string(Failure::step_limit));
  EXPECT_EQ(json["failures"][0]["t"], Json::parse("[0.5,0.0]"));
}

TEST(SolveJson, WritesNullWhereANumberIsUnknown) {
  SolveResult result = hand_made_result();
  result.solutions[0].accuracy = std::numeric_limits<double>::quiet_NaN();
  result.solutions[0].condition = std::numeric_limits<double>::infinity();
  result.solutions[0].x[1] = {std::numeric_limits<double>::quiet_NaN(), 0};
  result.system.total_degree.reset();
  const Json json = json_of(result);
  EXPECT_TRUE(json["solutions"][0]["accuracy"].is_null());
  EXPECT_TRUE(json["solutions"][0]["condition"].is_null());
  EXPECT_TRUE(json["solutions"][0]["x"][1][0].is_null());
  EXPECT_TRUE(json["system"]["total_degree"].is_null());
}

TEST(SolveJson, GivesTheTrackersOptionsAsNumbersWhereTheyAreNumbers) {
  const Json tracker = json_of(hand_made_result())["tracker"];
  EXPECT_EQ(tracker["kind"], "cvode");
  EXPECT_EQ(tracker["method"], "bdf_projection");
  EXPECT_EQ(tracker["rtol"], 0.01);
  EXPECT_TRUE(tracker["maximum_steps"].is_number_integer());
}

TEST(SolveJson, SurvivesAFileNameThatIsNotUtf8) {
  EXPECT_TRUE(Json::accept(solve_json(hand_made_result(), "\xff\xfe.phc")));
}

TEST(SolveJson, ListsAreEmptyWhereThereIsNothingToList) {
  const Json json = json_of(SolveResult{});
  for (const char* key : {"solutions", "failures", "left_out"}) {
    EXPECT_TRUE(json[key].is_array() && json[key].empty()) << key;
  }
}

}  // namespace
}  // namespace moivre::test
