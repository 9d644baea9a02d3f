// SPDX-License-Identifier: MIT
// moivre family learn, solve, info from the command line: what a user types, reads, and gets wrong.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kConicFamily = "2 5\na*x^2 + b*x*y + y^2 - c; x^2 + y^2 - x - 1;\n";

/// Learns a family in the scene.
void learn_conics(const Scene& scene) {
  scene.write("conics.phc", kConicFamily);
  const Outcome outcome =
      scene.run({"family", "learn", "conics.phc", "--parameters", "a,b,c", "-o", "conics.family"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "\na generic member has 4 roots; ")) << outcome.out;
}

TEST(FamilyCommand, LearnsAndSolvesAMember) {
  const Scene scene;
  learn_conics(scene);
  const Outcome one =
      scene.run({"family", "solve", "conics.family", "--at", "a=2,b=1/3,c=1.5", "--json", "-"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  const Json report = Json::parse(one.out);
  EXPECT_EQ(report["command"], "family solve");
  EXPECT_EQ(report["start"]["kind"], "family");
  EXPECT_EQ(report["solutions"].size(), 4U);
  EXPECT_EQ(report["at"]["c"], 1.5);
  const Outcome info = scene.run({"family", "info", "conics.family"});
  EXPECT_EQ(info.exit_code, 0);
  EXPECT_TRUE(has_line(info.out, "unknowns x, y; parameters a, b, c")) << info.out;
  const Outcome told = scene.run({"family", "info", "conics.family", "--json", "-"});
  EXPECT_EQ(Json::parse(told.out)["families"][0]["roots"], 4);
}

TEST(FamilyCommand, SolvesATable) {
  const Scene scene;
  learn_conics(scene);
  scene.write("in.csv", "a,b,c\n2,0.5,1.5\n1,0,2\n");
  const Outcome table = scene.run({"family", "solve", "conics.family", "--table", "in.csv", "--csv",
                                   "out.csv", "--json", "-", "--tracker", "lanes"});
  ASSERT_EQ(table.exit_code, 0) << table.err;
  const Json report = Json::parse(table.out);
  ASSERT_EQ(report["members"].size(), 2U);
  EXPECT_EQ(report["members"][0]["complex"], 4);
  EXPECT_EQ(report["members"][1]["complex"], 2);
  EXPECT_EQ(report["members"][1]["at_infinity"], 2);
  EXPECT_EQ(scene.read("out.csv").substr(0, 12), "member,a,b,c");
}

TEST(FamilyCommand, ReadsTheParametersOfABertiniFile) {
  const Scene scene;
  scene.write("line.bertini",
              "INPUT\nvariable_group x;\nparameter a;\nconstant b, c;\nfunction f;\nb = 40;\nc = "
              "2;\nf = a*x^2 + b*x + c;\nEND;\n");
  const Outcome outcome = scene.run(
      {"family", "learn", "line.bertini", "--parameters", "b", "-o", "line.family", "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json family = Json::parse(outcome.out)["families"][0];
  ASSERT_EQ(family["parameters"].size(), 2U);
  EXPECT_EQ(family["parameters"][0]["name"], "b");
  EXPECT_EQ(family["parameters"][0]["size"], 40);
  EXPECT_EQ(family["parameters"][1]["name"], "a");
}

TEST(FamilyCommand, SaysWhatIsWrong) {
  const Scene scene;
  learn_conics(scene);
  const auto refused = [&](const std::vector<std::string>& words, const std::string& expected) {
    const Outcome outcome = scene.run(words);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
    EXPECT_EQ(outcome.err, expected);
  };
  refused({"family", "learn", "conics.phc", "--parameters", "a,d", "-o", "x.family"},
          "moivre: the system has no name d; its names are a, x, b, y, c\n");
  refused({"family", "learn", "conics.phc", "-o", "x.family"},
          "moivre: conics.phc: no parameter is declared in the file; name them with --parameters "
          "a,b\n");
  refused({"family", "solve", "conics.family", "--at", "a=1"}, "moivre: no value for b, c\n");
  refused({"family", "solve", "conics.family"},
          "moivre: give the values of the parameters: --at a=1,b=2 for one member, or --table FILE "
          "for many\n");
  refused({"family", "solve", "conics.phc", "--at", "a=1"},
          "moivre: conics.phc: this is no family file; moivre family learn writes them\n");
  refused({"family", "sovle", "conics.family"},
          "moivre: unknown command sovle; did you mean solve?\n"
          "The commands are learn, solve, info.\n");
  refused({"family", "solve", "conics.family", "--att", "a=1"},
          "moivre: unknown option --att; did you mean --at?\n");
  scene.write("bad.csv", "a,b,c\n1,x,2\n");
  refused({"family", "solve", "conics.family", "--table", "bad.csv"},
          "bad.csv:2:3: error: this is not a number: x\n    1,x,2\n      ^\n");
}

}  // namespace
}  // namespace moivre::test
