// SPDX-License-Identifier: MIT
// Do table, CSV, script and page show what a study holds, with what is unknown left out?
#include "moivre/study_report/study_report.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace moivre {
namespace {

StudiedFile study_by_hand() {
  StudiedFile study;
  study.file = "folder/a,b<c>.phc";
  study.name = "a,b<c>";
  study.result.complete = true;
  study.result.seed = 1;
  study.result.seeds = 2;
  study.result.paths = 4;
  study.result.reference.roots = 3;
  StudyRow row;
  row.curve = "bdf";
  row.tolerance = 0.01;
  row.own.cpu_s = {0.002, 0.003, 0.004};
  row.own.lost = 2;
  row.repaired.cpu_s = {0.02, 0.03, 0.04};
  row.repaired.error = 1e-16;
  row.walk = StudyWalk{.paths = 3, .jumped = 1, .end_error = 1e-5};
  study.result.rows.push_back(row);
  row.curve = "lanes";
  row.own.lost = 0;
  row.walk.reset();
  row.repaired.error.reset();
  study.result.rows.push_back(row);
  return study;
}

/// Columns of a wide terminal: no row of a table is broken there.
constexpr std::size_t kTerminal = 132;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The rows of gnuplot's block of data of that name.
std::string data_of(const std::string& script, const std::string& name) {
  const std::string head = "$" + name + " << EOD\n";
  const std::size_t at = script.find(head);
  if (at == std::string::npos) return "no block " + name;
  const std::size_t begin = at + head.size();
  return script.substr(begin, script.find("EOD\n", begin) - begin);
}

TEST(StudyReport, TextHasARowASetting) {
  const std::string text = study_text(study_by_hand());
  EXPECT_TRUE(contains(text, "\nbdf "));
  for (std::size_t at = 0; at < text.find("\n\nown:"); at = text.find('\n', at) + 1) {
    EXPECT_LE(text.find('\n', at) - at, kTerminal) << text.substr(at, kTerminal);
  }
  EXPECT_TRUE(contains(text, "\nlanes "));
  EXPECT_TRUE(contains(text, "seeds 1 to 2"));
}

TEST(StudyReport, CsvRowsHaveAsManyFieldsAsTheHeadAndQuoteCommas) {
  const std::string csv = study_csv({study_by_hand()});
  const std::string head = csv.substr(0, csv.find('\n'));
  const std::size_t begin = csv.find('\n') + 1;
  const std::string row = csv.substr(begin, csv.find('\n', begin) - begin);
  EXPECT_EQ(row.rfind("\"folder/a,b<c>.phc\",bdf,0.01,", 0), 0u) << row;
  EXPECT_EQ(std::count(head.begin(), head.end(), ',') + 1, std::count(row.begin(), row.end(), ','));
}

TEST(StudyReport, ScriptMarksSettingsThatLoseRootsWithTheirNumber) {
  const std::string script = study_diagrams(study_by_hand()).at(0).script;
  EXPECT_EQ(data_of(script, "own0"), "0.003 1e-05 2\n");
  EXPECT_EQ(data_of(script, "own1"), "0.003 1 0\n");
  EXPECT_EQ(data_of(script, "solve0"), "0.03 1e-16 0\n");
  EXPECT_EQ(data_of(script, "solve1"), "0.03 1 0\n");
  EXPECT_EQ(data_of(script, "lost_own0"), "0.003 1e-05 2\n");
  EXPECT_TRUE(contains(script, "$lost_own0 using 1:2:3 with labels"));
  EXPECT_FALSE(contains(script, "$lost_solve0 using"));
  EXPECT_TRUE(contains(script, "CPU time of all paths [s]"));
}

TEST(StudyReport, WithoutRowsThereIsNothingToDraw) {
  StudiedFile study = study_by_hand();
  study.result.rows.clear();
  EXPECT_TRUE(study_diagrams(study).empty());
}

TEST(StudyReport, AMotionHasADiagramOfItsErrorsOverItsTime) {
  StudiedFile study = study_by_hand();
  study.result.tables.push_back(
      {"motion", {"samples", "cpu_s", "velocity_error"}, {{50, 0.01, 1e-5}, {100, 0.02, 0}}});
  study.result.tables.push_back({"without errors", {"samples", "cpu_s"}, {{50, 0.01}}});
  const std::vector<StudyDiagram> diagrams = study_diagrams(study);
  ASSERT_EQ(diagrams.size(), 2u);
  EXPECT_EQ(diagrams[1].name, study.name + "-motion");
  EXPECT_TRUE(contains(diagrams[1].script, "0.01 1e-05 50\n0.02 1e-18 100\nEOD"));
  EXPECT_TRUE(contains(diagrams[1].script, "CPU time of the motion [s]"));
  EXPECT_TRUE(contains(diagrams[1].script, "title \"velocity\""));
}

TEST(StudyReport, TheTableHasEveryQuantityThatIsPromised) {
  const std::string text = study_text(study_by_hand());
  for (const char* heading :
       {"own s", "least", "most", "error", "plain err", "|H| before", "|H| after", "lost", "jumped",
        "again", "steps", "evaluated", "factored"}) {
    EXPECT_TRUE(contains(text, heading)) << heading;
  }
}

TEST(StudyReport, PageHoldsTheDiagramAndEscapesNames) {
  StudiedFile study = study_by_hand();
  study.diagrams = study_diagrams(study);
  EXPECT_TRUE(contains(study_html({study}), "No diagram"));
  study.diagrams.at(0).svg = "<?xml version=\"1.0\"?>\n<svg>drawn</svg>";
  const std::string page = study_html({study});
  EXPECT_TRUE(contains(page, "<svg>drawn</svg>"));
  EXPECT_FALSE(contains(page, "<?xml"));
  EXPECT_TRUE(contains(page, "a,b&lt;c&gt;"));
  EXPECT_FALSE(contains(page, "<c>"));
}

TEST(KnownCount, ComesFromTheIndexBesideTheFile) {
  const std::string folder = std::string(MOIVRE_SOURCE_DIR) + "/problems/polynomials/";
  EXPECT_EQ(known_count(folder + "noon-3.phc"), 21u);
  EXPECT_FALSE(known_count(folder + "no-such.phc"));
  EXPECT_FALSE(known_count(folder + "ipp2.phc"));  // some of its roots need not be found
  EXPECT_FALSE(known_count("elsewhere/noon-3.phc"));
}

}  // namespace
}  // namespace moivre
