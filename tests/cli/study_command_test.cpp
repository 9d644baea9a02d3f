// SPDX-License-Identifier: MIT
// Does `moivre study` refuse before it runs, write its folder, draw where gnuplot is, and end
// cleanly when interrupted?
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "problems.h"
#include "program.h"
#include "refusing.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> kShort{"--seeds", "1",          "--tolerances",
                                      "1e-2",    "--settings", "bdf_projection,adams"};

std::vector<std::string> study(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "study");
  arguments.insert(arguments.end(), kShort.begin(), kShort.end());
  return arguments;
}

/// PATH is another one while it lives.
class OtherPath {
 public:
  explicit OtherPath(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~OtherPath() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

TEST(StudyCommand, MeasuresEachSettingAgainstTheReference) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run(study({"f.phc", "--json", "-", "--count", "4"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["complete"], true);
  const Json& file = report["files"][0];
  EXPECT_EQ(file["reference"]["known"], 4);
  EXPECT_EQ(file["reference"]["complete"], true);
  ASSERT_EQ(file["settings"].size(), 2u);
  EXPECT_EQ(file["settings"][0]["curve"], "bdf_projection");
  EXPECT_EQ(file["settings"][1]["tracker"]["method"], "adams");
  EXPECT_EQ(file["settings"][0]["solve"]["lost"], 0);
}

TEST(StudyCommand, SaysWithExitCodeTwoThatTheReferenceIsNotComplete) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run(study({"f.phc", "--count", "5", "--json", "-"}));
  EXPECT_EQ(outcome.exit_code, 2);
  const Json report = Json::parse(outcome.out);
  const Json& reference = report["files"][0]["reference"];
  EXPECT_EQ(reference["known"], 5);
  EXPECT_EQ(reference["with_multiplicity"], 4);
  EXPECT_EQ(reference["complete"], false);
}

TEST(StudyCommand, TakesMechanismsAndPolynomialsTogether) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const std::string mechanism =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
  const Outcome outcome = scene.run(study({"f.phc", mechanism, "--json", "-"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  ASSERT_EQ(report["files"].size(), 2u);
  EXPECT_EQ(report["files"][1]["reference"]["roots"], 2);
  EXPECT_EQ(report["files"][1]["settings"][0]["walk"], nullptr);
}

TEST(StudyCommand, FillsAFolderWithScriptsAndDrawsThemWhereGnuplotIs) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run(study({"f.phc", "f.phc", "--out", "new/folder"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"study.csv", "index.html", "f.gp", "f-2.gp"}) {
    EXPECT_TRUE(scene.has(std::string("new/folder/") + name)) << name;
  }
  if (!contains(outcome.err, "gnuplot is not installed")) {
    EXPECT_TRUE(contains(scene.read("new/folder/f.svg"), "<svg"));
    EXPECT_TRUE(contains(scene.read("new/folder/index.html"), "<svg"));
  }
}

TEST(StudyCommand, NamesItsFilesSoThatGnuplotReadsNoCommandInThem) {
  Scene scene;
  const std::string name = "-a`touch b`\"c.phc";
  scene.write(name, kCircleAndHyperbola);
  const Outcome outcome = scene.run(study({"./" + name, "--out", "folder"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(scene.has("folder/_a_touch b__c.gp")) << outcome.err;
  EXPECT_FALSE(scene.has("folder/b"));
}

TEST(StudyCommand, LeavesTheScriptWhereGnuplotIsNot) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const OtherPath nowhere("/nowhere");
  const Outcome outcome = scene.run(study({"f.phc", "--out", "folder"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err,
            "no diagrams: gnuplot is not installed; its scripts are there for later\n");
  EXPECT_TRUE(scene.has("folder/f.gp"));
  EXPECT_FALSE(scene.has("folder/f.svg"));
  EXPECT_TRUE(contains(scene.read("folder/index.html"), "No diagram"));
}

TEST(StudyCommand, RefusesEachWrongOptionWithItsReason) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  scene.write("wide.phc", "1 2\nx + y;\n");
  scene.write("torn.phc", "1\nx - ;\n");
  scene.write("file", "");
  const std::vector<Refusal> refusals = {
      {{"f.phc", "--settings", "euler,lanes,heun"},
       "moivre: --settings euler,heun: the settings are bdf_projection, bdf_projection+newton, "
       "bdf, bdf+newton, adams, adams+newton, lanes, lanes+cubic, lanes+tangent\n"},
      {{"f.phc", "--tolerances", "0"}, "moivre: rtol must lie in (0, 0.5]\n"},
      {{"f.phc", "--tolerances", "1e-2,2"}, "moivre: rtol must lie in (0, 0.5]\n"},
      {{"f.phc", "--seeds", "0"}, "moivre: seeds must lie between 1 and 1000\n"},
      {{"f.phc", "--seed", "-1"}, "moivre: --seed: -1 is negative\n"},
      {{"f.phc", "--count", "-1"}, "moivre: --count: -1 is negative\n"},
      {{"f.phc", "--out", "file"},
       "moivre: --out file: cannot make this folder: Not a directory\n"},
      {{"f.phc", "--out", "/proc/nowhere"},
       "moivre: --out /proc/nowhere: cannot make this folder: "},
      {{"f.phc", "--csv", "no/folder/x.csv"},
       "moivre: cannot write no/folder/x.csv: No such file or directory\n"},
      {{"f.phc", "--json", "f.phc"}, "moivre: the result would overwrite the problem file f.phc\n"},
      {{"f.phc", "absent.phc"},
       "moivre: absent.phc: cannot be opened: No such file or directory\n"},
      {{"wide.phc"},
       "moivre: wide.phc: 1 equation in 2 unknowns; as many equations as unknowns are needed\n"},
      {{"torn.phc"},
       "torn.phc:2:4: error: expected a number, a name or `(`, but the expression ends here\n"
       "    x - ;\n"
       "       ^\n"},
      {{}, "moivre: FILE is required\n"}};
  for (const Refusal& refusal : refusals) {
    std::vector<std::string> arguments = {"study"};
    arguments.insert(arguments.end(), refusal.options.begin(), refusal.options.end());
    const Outcome outcome = scene.run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << refusal.message;
    EXPECT_EQ(outcome.out, "") << refusal.message;
    EXPECT_TRUE(outcome.err.starts_with(refusal.message)) << outcome.err;
  }
}

TEST(StudyCommand, SaysWhereThereIsNothingToCompare) {
  Scene scene;
  scene.write("line.phc", "2\nx + y - 1;\n2*x + 2*y - 2;\n");
  const std::string triangle =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/unassemblable-triangle.toml";
  const Outcome outcome =
      scene.run(study({"line.phc", triangle, "--out", "folder", "--json", "-"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string of_line = "there is no isolated root: only times can be compared";
  const std::string of_triangle =
      "no closure is real: the mechanism cannot be assembled, and has no motion";
  const Json files = Json::parse(outcome.out)["files"];
  EXPECT_EQ(files[0]["remarks"], Json({of_line}));
  EXPECT_EQ(files[1]["remarks"], Json({of_triangle}));
  const std::string text = scene.run(study({"line.phc", triangle})).out;
  EXPECT_TRUE(has_line(text, of_line)) << text;
  EXPECT_TRUE(has_line(text, of_triangle)) << text;
  EXPECT_FALSE(scene.has("folder/line.gp"));
}

TEST(StudyCommand, GivesWhatIsFinishedWhenItIsInterrupted) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run({"study", "f.phc", "--full", "--seeds", "1000", "--json", "-"},
                                    false, [](int process) {
                                      ASSERT_TRUE(catches_interrupt(process));
                                      kill(process, SIGINT);
                                    });
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["complete"], false);
}

}  // namespace
}  // namespace moivre::test
