// SPDX-License-Identifier: MIT
// Does a sweep's page hold the closures of every sample, thinned where there are too many, and no
// name as markup?
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "moivre/closure_report/sweep_report.h"
#include "moivre/mechanism/dimensions.h"
#include "moivre/mechanism/read.h"
#include "moivre/tracker_lanes/lane_tracker.h"

namespace moivre {
namespace {

using PageData = nlohmann::json;

Mechanism mechanism_of(const std::string& name) {
  return read_mechanism(read_source(MOIVRE_SOURCE_DIR "/problems/mechanisms/" + name + ".toml"));
}

SweepResult sweep_of(const Mechanism& mechanism, const std::vector<Varied>& varied) {
  FamilyBook book;
  SweepOptions options;
  options.keep_closures = true;
  options.sharpen = false;
  return sweep(mechanism, varied, *make_lane_tracker(), book, options);
}

PageData data_in(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  return PageData::parse(page.substr(from, page.find("</script>", from) - from));
}

double distance(const PageData& closure, std::size_t a, std::size_t b) {
  return std::hypot(closure[2 * a].get<double>() - closure[2 * b].get<double>(),
                    closure[2 * a + 1].get<double>() - closure[2 * b + 1].get<double>());
}

TEST(SweepPage, PutsEveryPointWhereTheSamplesDimensionsDo) {
  const Mechanism mechanism = mechanism_of("four-bar");
  const SweepResult result = sweep_of(mechanism, {{"crank.A.x", 100, 299, 20}});
  const PageData data = data_in(sweep_html(result, mechanism, "four-bar.toml"));
  ASSERT_EQ(data["closures"].size(), 20U);
  const PageData& crank = data["bodies"][0]["points"];
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_EQ(data["closures"][k].size(), result.samples[k].found.real);
    for (const PageData& closure : data["closures"][k]) {
      // The crank is as long as its point A says, which is what varies.
      EXPECT_NEAR(distance(closure, crank[0], crank[1]), data["axes"][0]["values"][k], 1e-4);
    }
  }
  EXPECT_EQ(data["ids"], PageData({"A", "B"}));
  EXPECT_EQ(data["axes"][0]["unit"], "mm");
  EXPECT_EQ(data["told"][0], "2 complex closures, 2 real");
}

TEST(SweepPage, ThinsTheSamplesThatAreTooManyForABrowser) {
  SweepResult result;
  result.varied = {{"leg 1.length", 8, 24, 301}, {"leg 2.length", 8, 24, 201}};
  for (std::size_t i = 0; i < 301; ++i) {
    for (std::size_t j = 0; j < 201; ++j) {
      SweepSample sample;
      sample.at = {result.varied[0].at(i), result.varied[1].at(j)};
      sample.complex = i * 201 + j;
      sample.complete = true;
      result.samples.push_back(std::move(sample));
    }
  }
  const std::string page = sweep_html(result, mechanism_of("3-rpr"), "3-rpr.toml");
  const PageData data = data_in(page);
  // Every third value of both: 101 x 67 of 301 x 201.
  ASSERT_EQ(data["told"].size(), 101U * 67U);
  EXPECT_LE(data["told"].size(), kMostShown);
  EXPECT_NE(page.find("Of 60501 samples the closures of 6767 are in the page."), std::string::npos);
  EXPECT_NEAR(data["axes"][0]["values"][1], 8 + 16.0 * 3 / 300, 1e-12);
  EXPECT_EQ(data["told"][67 + 1], std::to_string(3 * 201 + 3) + " complex closures, 0 real");
}

TEST(SweepPage, ListsTheUnknownsOfTypedEquations) {
  const Mechanism mechanism = mechanism_of("slider-crank-equations");
  ASSERT_TRUE(is_typed(mechanism));
  const std::string driver = dimension_names(mechanism).front();
  const SweepResult result = sweep_of(mechanism, {{driver, 20, 34, 8}});
  const PageData data = data_in(sweep_html(result, mechanism, "file"));
  ASSERT_EQ(data["unknowns"].size(), mechanism.unknowns.size());
  for (std::size_t k = 0; k < 8; ++k) {
    ASSERT_EQ(data["closures"][k].size(), 2U);
    for (const PageData& closure : data["closures"][k]) {
      EXPECT_EQ(closure.size(), mechanism.unknowns.size());
    }
  }
}

TEST(SweepPage, TakesNoNameForMarkup) {
  Mechanism mechanism = mechanism_of("four-bar");
  mechanism.title = "</script><script>alert(1)</script>";
  const SweepResult result = sweep_of(mechanism, {{"crank.A.x", 100, 200, 2}});
  const std::string page = sweep_html(result, mechanism, mechanism.title);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert"), std::string::npos);
}

}  // namespace
}  // namespace moivre
