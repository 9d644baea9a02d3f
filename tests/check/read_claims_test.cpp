// SPDX-License-Identifier: MIT
// Is what is no result refused, with every fault named by its place?
#include <gtest/gtest.h>

#include <stdexcept>

#include "moivre/check/claims.h"
#include "results.h"

namespace moivre::test {
namespace {

std::string refusal(const std::string& text) {
  try {
    read_claims({"r.json", text}, {"x", "y", "z"});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string refusal_with(const std::function<void(Json&)>& change) {
  Json result = honest("plane");
  change(result);
  return refusal(result.dump());
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ReadClaims, TakesEveryKeyOfAResult) {
  const Claims claims = read_claims({"r.json", result_text("plane-40.json")}, {"x", "y", "z"});
  EXPECT_EQ(claims.form, ClaimForm::solve_json);
  ASSERT_EQ(claims.roots.size(), 4U);
  EXPECT_TRUE(claims.complete);
  EXPECT_EQ(claims.digits, 40);
  EXPECT_EQ(claims.roots[2].x_digits.size(), 3U);
  EXPECT_EQ(claims.start->mixed_volume, 4U);
  EXPECT_EQ(claims.failures, 0U);
  EXPECT_FALSE(claims.completeness);
  EXPECT_FALSE(claims.roots[0].certified);
}

TEST(ReadClaims, NamesWhereJsonBreaksOff) {
  const std::string text = result_text("plane.json");
  EXPECT_TRUE(contains(refusal(text.substr(0, text.size() / 2)), "r.json:"));
  EXPECT_TRUE(contains(refusal(text.substr(0, text.size() / 2)), "broken or cut off here"));
  EXPECT_TRUE(contains(refusal("{\"command\": NaN}"), "r.json:1:13"));
  EXPECT_TRUE(contains(refusal("{\"seed\": 1e999}"), "a number in the JSON is beyond double"));
}

TEST(ReadClaims, NamesEveryValueOfAnotherKind) {
  const std::string text = refusal_with([](Json& r) {
    r["solutions"][3]["x"][1] = "2";
    r["solutions"][0]["multiplicity"] = -1;
    r["solutions"][1]["real"] = 1;
    r["solutions"][2]["accuracy"] = "small";
    r["paths"].erase("failed");
    r["complete"] = "yes";
    r["completeness"] = "surely";
  });
  for (const char* fault :
       {"solutions[3].x[1]: expected a list, found string",
        "solutions[0].multiplicity: expected a whole number from 0, found number",
        "solutions[1].real: expected true or false, found number",
        "solutions[2].accuracy: expected a number, found string", "paths.failed: missing",
        "complete: expected true or false, found string", "completeness: expected \"proved\""}) {
    EXPECT_TRUE(contains(text, fault)) << fault << '\n' << text;
  }
}

TEST(ReadClaims, RefusesPointsOfAnotherDimension) {
  EXPECT_TRUE(contains(refusal_with([](Json& r) { r["solutions"][0]["x"].erase(2); }),
                       "solutions[0].x: expected 3 coordinates, found 2"));
  EXPECT_TRUE(contains(refusal_with([](Json& r) { r["solutions"][0]["x"][1] = {1}; }),
                       "solutions[0].x[1]: expected [re, im]"));
}

TEST(ReadClaims, RefusesForeignFiles) {
  EXPECT_TRUE(contains(refusal(R"({"command": "info"})"), "expected the JSON of \"solve\""));
  EXPECT_TRUE(contains(refusal(R"({"name": "something", "version": 2})"), "command: missing"));
  EXPECT_TRUE(contains(refusal("[1, 2, 3]"), "expected an object, found array"));
  EXPECT_TRUE(contains(refusal("<html>"), "neither the JSON of moivre solve nor"));
  EXPECT_TRUE(contains(refusal(" \n"), "the file is empty"));
}

TEST(ReadClaims, NamesNoMoreFaultsThanHelp) {
  const std::string text = refusal_with([](Json& r) {
    Json& list = r["solutions"];
    while (list.size() < 100) list.push_back(list[0]);
    for (Json& solution : list) solution["x"] = 0;
  });
  EXPECT_TRUE(contains(text, "and 80 more")) << text;
}

}  // namespace
}  // namespace moivre::test
