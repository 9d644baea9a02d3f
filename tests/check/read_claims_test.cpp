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

const std::string kNoResult = "r.json: no result of moivre solve\n";

TEST(ReadClaims, NamesWhereJsonBreaksOff) {
  const std::string text = result_text("plane.json");
  EXPECT_EQ(refusal(text.substr(0, text.size() / 2)),
            "r.json:15:20: error: the JSON is broken or cut off here\n"
            "        {\"path\":1,\"x\":[\n"
            "                       ^\n");
  EXPECT_EQ(refusal("{\"command\": NaN}"),
            "r.json:1:13: error: the JSON is broken or cut off here\n"
            "    {\"command\": NaN}\n"
            "                ^\n");
  EXPECT_EQ(refusal("{\"seed\": 1e999}"), "r.json: a number in the JSON is beyond double");
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
  EXPECT_EQ(text, kNoResult +
                      "  complete: expected true or false, found string\n"
                      "  paths.failed: missing\n"
                      "  completeness: expected \"proved\", \"shown\", \"open\" or null\n"
                      "  solutions[0].multiplicity: expected a whole number from 0, found number\n"
                      "  solutions[1].real: expected true or false, found number\n"
                      "  solutions[2].accuracy: expected a number, found string\n"
                      "  solutions[3].x[1]: expected a list, found string");
}

TEST(ReadClaims, RefusesPointsOfAnotherDimension) {
  EXPECT_EQ(refusal_with([](Json& r) { r["solutions"][0]["x"].erase(2); }),
            kNoResult + "  solutions[0].x: expected 3 coordinates, found 2");
  EXPECT_EQ(refusal_with([](Json& r) { r["solutions"][0]["x"][1] = {1}; }),
            kNoResult + "  solutions[0].x[1]: expected [re, im]");
}

TEST(ReadClaims, RefusesForeignFiles) {
  EXPECT_EQ(refusal(R"({"command": "info"})"),
            kNoResult + "  command: expected the JSON of \"solve\"");
  EXPECT_EQ(refusal(R"({"name": "something", "version": 2})"),
            kNoResult +
                "  command: missing\n  seed: missing\n  complete: missing\n  system: missing\n  "
                "paths: missing\n  solutions: missing");
  EXPECT_EQ(refusal("[1, 2, 3]"), kNoResult + "  the file: expected an object, found array");
  EXPECT_EQ(
      refusal("<html>"),
      "r.json: neither the JSON of moivre solve nor a solution list of PHCpack (THE SOLUTIONS)");
  EXPECT_EQ(refusal(" \n"), "r.json: the file is empty");
}

TEST(ReadClaims, NamesNoMoreFaultsThanHelp) {
  const std::string text = refusal_with([](Json& r) {
    Json& list = r["solutions"];
    while (list.size() < 100) list.push_back(list[0]);
    for (Json& solution : list) solution["x"] = 0;
  });
  EXPECT_TRUE(text.ends_with("\n  solutions[19].x: expected a list, found number\n  and 80 more"))
      << text;
}

}  // namespace
}  // namespace moivre::test
