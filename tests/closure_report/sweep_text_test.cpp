// SPDX-License-Identifier: MIT
// Does a sweep say what it counts: closures outside limits, fitted ones, and where the mechanism
// moves?
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "moivre/closure_report/sweep_report.h"

namespace moivre {
namespace {

/// Three samples: as it should be, with a closure beyond a limit, and moving.
SweepResult swept() {
  SweepResult result;
  result.varied = {{"rod", 1, 3, 3}};
  result.complete = true;
  const std::vector<Assemblies> found{{2, 0, 0, false}, {2, 1, 0, false}, {0, 0, 0, true}};
  for (std::size_t k = 0; k < 3; ++k) {
    result.samples.push_back({{result.varied[0].at(k)}, 2, found[k], true, {}});
  }
  for (std::size_t k = 0; k < 2; ++k) {
    result.borders.push_back({{1.5 + static_cast<double>(k)}, found[k], found[k + 1], 0});
  }
  return result;
}

TEST(SweepText, TellsLimitsAndMotion) {
  EXPECT_EQ(sweep_text(swept(), "file"),
            "file: 3 samples, rod from 1 to 3\n"
            "  0 real closures, and it moves though the drivers stand: 1 sample\n"
            "  2 real closures: 1 sample\n"
            "  2 real closures, 1 outside a joint's limits: 1 sample\n"
            "border at rod = 1.5: 2 | 2 (1 outside limits)\n"
            "border at rod = 2.5: 2 (1 outside limits) | moves\n");
}

TEST(SweepText, TellsTheMechanismsWarnings) {
  const std::string text = sweep_text(swept(), "file", {"body 'arm' is not tied"});
  EXPECT_NE(text.find("rod from 1 to 3\nwarning: body 'arm' is not tied\n"), std::string::npos)
      << text;
  const auto json = nlohmann::json::parse(sweep_json(swept(), "file", {"body 'arm' is not tied"}));
  EXPECT_EQ(json["warnings"], nlohmann::json({"body 'arm' is not tied"}));
}

TEST(SweepText, TellsFittedClosuresBesideTheRealOnes) {
  SweepResult result = swept();
  result.samples[0].found = {0, 0, 1, false};
  result.borders[0].below = result.samples[0].found;
  const std::string text = sweep_text(result, "file");
  EXPECT_NE(text.find("  0 real closures, 1 within fit: 1 sample\n"), std::string::npos) << text;
  EXPECT_NE(text.find("rod = 1.5: 0 (1 within fit) | 2"), std::string::npos) << text;
}

TEST(SweepCsv, HasWhatTheTextTells) {
  EXPECT_EQ(sweep_csv(swept()),
            "rod,complex,real,complete,moves,filtered,fitted\n"
            "1,2,2,1,0,0,0\n"
            "2,2,2,1,0,1,0\n"
            "3,2,0,1,1,0,0\n");
}

TEST(SweepJson, HasBothSidesOfABorder) {
  const auto json = nlohmann::json::parse(sweep_json(swept(), "file"));
  EXPECT_EQ(json["samples"][1]["filtered"], 1);
  EXPECT_EQ(json["borders"][0]["filtered"], nlohmann::json({0, 1}));
  EXPECT_EQ(json["borders"][1]["moves"], nlohmann::json({false, true}));
}

std::size_t count_of(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
    ++count;
  }
  return count;
}

TEST(SweepPicture, ShowsWhereItMovesAndWhatIsWithinLimits) {
  const std::string svg = sweep_svg(swept(), "file");
  EXPECT_EQ(count_of(svg, ">moves<"), 1U);
  EXPECT_EQ(count_of(svg, ">within limits<"), 1U);
  EXPECT_EQ(count_of(svg, "#c7e9c0"), 2U);  // the band and its entry in the legend
  SweepResult plain = swept();
  for (SweepSample& sample : plain.samples) sample.found = {2, 0, 0, false};
  plain.borders.clear();
  const std::string simple = sweep_svg(plain, "file");
  EXPECT_EQ(count_of(simple, ">moves<") + count_of(simple, ">within limits<"), 0U);
}

}  // namespace
}  // namespace moivre
