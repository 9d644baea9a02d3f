// SPDX-License-Identifier: MIT
// Does `moivre study` refuse before it runs, write its folder, draw where gnuplot is, and end cleanly when interrupted?
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "problems.h"
#include "program.h"

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
  EXPECT_TRUE(contains(outcome.err, "gnuplot is not installed"));
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
  struct Refusal {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::vector<Refusal> refusals = {
      {{"f.phc", "--settings", "euler,lanes,heun"},
       "--settings euler,heun: the settings are bdf_projection"},
      {{"f.phc", "--tolerances", "0"}, "rtol must lie in (0, 0.5]"},
      {{"f.phc", "--tolerances", "1e-2,2"}, "rtol must lie in (0, 0.5]"},
      {{"f.phc", "--seeds", "0"}, "seeds must lie between 1 and"},
      {{"f.phc", "--seed", "-1"}, "--seed: -1 is negative"},
      {{"f.phc", "--count", "-1"}, "--count: -1 is negative"},
      {{"f.phc", "--out", "file"}, "--out file: cannot make this folder"},
      {{"f.phc", "--out", "/proc/nowhere"}, "--out /proc/nowhere: cannot make this folder"},
      {{"f.phc", "--csv", "no/folder/x.csv"}, "no/folder/x.csv"},
      {{"f.phc", "--json", "f.phc"}, "f.phc"},
      {{"f.phc", "absent.phc"}, "absent.phc"},
      {{"wide.phc"}, "wide.phc: 1 equation in 2 unknowns"},
      {{"torn.phc"}, "torn.phc:2:"},
      {{}, "FILE"}};
  for (const Refusal& refusal : refusals) {
    std::vector<std::string> arguments = {"study"};
    arguments.insert(arguments.end(), refusal.arguments.begin(), refusal.arguments.end());
    const Outcome outcome = scene.run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << refusal.message;
    EXPECT_EQ(outcome.out, "") << refusal.message;
    EXPECT_TRUE(contains(outcome.err, refusal.message)) << outcome.err;
  }
}

TEST(StudyCommand, SaysWhereThereIsNothingToCompare) {
  Scene scene;
  scene.write("line.phc", "2\nx + y - 1;\n2*x + 2*y - 2;\n");
  const std::string triangle =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/unassemblable-triangle.toml";
  const Outcome outcome = scene.run(study({"line.phc", triangle, "--out", "folder"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "there is no isolated root")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "the mechanism cannot be assembled")) << outcome.out;
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
