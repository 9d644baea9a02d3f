// SPDX-License-Identifier: MIT
// Is what README and docs/results/study.md advise true of the committed study, and does that hold
// what it should?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace moivre {
namespace {

const std::string kSource = MOIVRE_SOURCE_DIR;

using Row = std::map<std::string, std::string>;

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

std::vector<Row> committed_rows() {
  std::ifstream stream(kSource + "/docs/results/study/study.csv");
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> head = fields_of(line);
  std::vector<Row> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> fields = fields_of(line);
    Row& row = rows.emplace_back();
    for (std::size_t k = 0; k < fields.size(); ++k) row[head.at(k)] = fields[k];
  }
  return rows;
}

std::string text_of(const std::string& file) {
  std::ifstream stream(kSource + '/' + file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A setting over all problems.
struct Total {
  double cpu_s = 0;
  int lost = 0;         ///< by paths followed once
  int lost_untold = 0;  ///< of these, by paths that were not reported as failed
  int lost_by_solve = 0;
  int failed = 0;
  bool is_clean() const { return lost == 0 && failed == 0; }
};

std::map<std::pair<std::string, double>, Total> totals() {
  std::map<std::pair<std::string, double>, Total> all;
  for (const Row& row : committed_rows()) {
    Total& total = all[{row.at("curve"), std::stod(row.at("tolerance"))}];
    total.cpu_s += std::stod(row.at("cpu_s"));
    const int lost = std::stoi(row.at("own_lost"));
    total.lost += lost;
    total.lost_untold += std::max(lost - std::stoi(row.at("own_failed")), 0);
    total.lost_by_solve += std::stoi(row.at("lost"));
    total.failed += std::stoi(row.at("failed"));
  }
  return all;
}

TEST(CommittedStudy, HasTwelveProblemsAndMoreOfBothKindsWithEveryMethodAndDecade) {
  std::set<std::string> files;
  std::map<std::string, std::set<int>> decades;
  for (const Row& row : committed_rows()) {
    files.insert(row.at("file"));
    decades[row.at("curve")].insert(
        static_cast<int>(std::lround(std::log10(std::stod(row.at("tolerance"))))));
  }
  EXPECT_GE(files.size(), 12u);
  EXPECT_TRUE(files.contains("problems/mechanisms/jansen-leg.toml"));
  for (const char* curve : {"bdf_projection", "bdf_projection+newton", "bdf", "bdf+newton", "adams",
                            "adams+newton", "lanes"}) {
    EXPECT_EQ(decades[curve].size(), 10u) << curve;
  }
  EXPECT_TRUE(decades.contains("lanes+cubic") && decades.contains("lanes+tangent"));
  EXPECT_NE(text_of("README.md").find("on the " + std::to_string(files.size()) + " problems"),
            std::string::npos);
}

// "`solve` lost no root", in less than half the time of any setting of CVODE that lost none; what
// paths followed once lost was reported.
TEST(CommittedStudy, LanesLoseNothingInLessThanHalfTheTimeOfAnySettingOfCvodeThatLosesNothing) {
  const auto all = totals();
  const Total& lanes = all.at({"lanes", 1e-2});
  for (const double tolerance : {1e-2, 1e-3}) {
    const Total& total = all.at({"lanes", tolerance});
    EXPECT_EQ(total.lost_by_solve, 0);
    EXPECT_EQ(total.failed, 0);
    EXPECT_EQ(total.lost_untold, 0);
    EXPECT_LE(total.lost, 1);
  }
  for (const auto& [setting, total] : all) {
    if (setting.first.starts_with("lanes") || !total.is_clean()) continue;
    EXPECT_LT(2 * lanes.cpu_s, total.cpu_s) << setting.first << ' ' << setting.second;
  }
}

// "Paths followed once lost none with CVODE", while without projection roots are lost at each such
// tolerance.
TEST(CommittedStudy, CvodeWithProjectionLosesNothingAtItsDefaultAndWithoutItDoes) {
  const auto all = totals();
  EXPECT_TRUE(all.at({"bdf_projection", 1e-2}).is_clean());
  EXPECT_GT(all.at({"bdf", 1e-2}).lost, 0);
  EXPECT_GT(all.at({"adams", 1e-2}).lost, 0);
}

// "Tighter tolerances make no delivered root better."
TEST(CommittedStudy, DeliveredRootsAreAsGoodAtEveryToleranceThatLosesNone) {
  std::map<std::string, double> best;
  const std::vector<Row> rows = committed_rows();
  for (const Row& row : rows) {
    if (row.at("curve") != "bdf_projection" || row.at("error").empty()) continue;
    const double error = std::stod(row.at("error"));
    const auto [entry, is_new] = best.emplace(row.at("file"), error);
    if (!is_new) entry->second = std::min(entry->second, error);
  }
  constexpr double kRounding = 0x1p-52;
  for (const Row& row : rows) {
    if (row.at("curve") != "bdf_projection" || row.at("error").empty()) continue;
    EXPECT_LE(std::stod(row.at("error")), best.at(row.at("file")) + kRounding) << row.at("file");
  }
}

TEST(CommittedStudy, HasEachDiagramWithItsScript) {
  const std::string page = text_of("docs/results/study.md");
  for (const char* name : {"katsura-6", "puma", "jansen-leg-motion", "four-bar-motion"}) {
    const std::string file = std::string("docs/results/study/") + name;
    EXPECT_TRUE(text_of(file + ".svg").ends_with("</svg>\n\n")) << name;
    EXPECT_NE(text_of(file + ".gp").find(std::string("\nset output \"") + name + ".svg\"\n"),
              std::string::npos)
        << name;
    EXPECT_NE(page.find(std::string("(study/") + name + ".svg)"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace moivre
