// SPDX-License-Identifier: MIT
// Does the program explain itself, and does it guess what a typo meant?
#include <gtest/gtest.h>

#include "program.h"
#include "suggest.h"

namespace moivre::test {
namespace {

TEST(CommandLine, ShowsExamplesInTheHelpOfEveryCommand) {
  const Scene scene;
  for (const char* command : {"solve", "track", "info"}) {
    const Outcome outcome = scene.run({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(contains(outcome.out, "Examples:\n  moivre " + std::string(command)))
        << outcome.out;
    EXPECT_EQ(outcome.err, "");
  }
}

TEST(CommandLine, ListsTheCommands) {
  const Outcome outcome = Scene().run({"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* command : {"solve", "track", "info"})
    EXPECT_TRUE(contains(outcome.out, command));
}

TEST(CommandLine, TellsItsVersion) {
  const Outcome outcome = Scene().run({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "moivre " MOIVRE_VERSION "\n");
}

constexpr const char* kTheCommands =
    "The commands are solve, track, info, closures, motion, newton, mobility, guesses, mechanism, "
    "study, check, family, sweep, ledger.\n";

TEST(CommandLine, SuggestsTheCommandThatATypoMeant) {
  const Outcome outcome = Scene().run({"slove", "f.phc"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            std::string("moivre: unknown command slove; did you mean solve?\n") + kTheCommands);
}

TEST(CommandLine, SuggestsNothingWhereNothingIsAlike) {
  const Outcome outcome = Scene().run({"entirely-different"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            std::string("moivre: unknown command entirely-different\n") + kTheCommands);
}

TEST(CommandLine, AsksForACommandAndForAFile) {
  const Scene scene;
  EXPECT_EQ(scene.run({}).exit_code, 1);
  EXPECT_EQ(scene.run({"solve"}).exit_code, 1);
  EXPECT_EQ(scene.run({"solve"}).err,
            "moivre: FILE is required\nmoivre --help shows how to call it.\n");
}

TEST(CommandLine, TakesTheCommonOptionsWhereverAPolynomialFileIsRead) {
  Scene scene;
  scene.write("f.phc", "1\nx^2 - 1;\n");
  for (const std::vector<std::string>& command : {std::vector<std::string>{"solve", "f.phc"},
                                                  {"info", "f.phc"},
                                                  {"track", "f.phc", "--path", "0"}}) {
    std::vector<std::string> arguments = command;
    for (const char* word :
         {"--start", "total-degree", "--seed", "3", "--threads", "2", "--quiet", "--json", "-"}) {
      arguments.emplace_back(word);
    }
    const Outcome outcome = scene.run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << command[0] << outcome.err;
    EXPECT_EQ(outcome.err, "") << command[0];
    EXPECT_EQ(outcome.out.front(), '{') << command[0];
    arguments[command.size() + 1] = "magic";
    EXPECT_EQ(scene.run(arguments).exit_code, 1) << command[0];
  }
}

TEST(CommandLine, RefusesASecondFile) {
  Scene scene;
  scene.write("f.phc", "1\nx - 1;\n");
  EXPECT_EQ(scene.run({"solve", "f.phc", "g.phc"}).exit_code, 1);
}

TEST(CommandLine, SaysWhenItsResultCouldNotBeWritten) {
  Scene scene;
  scene.write("f.phc", "1\nx^2 - 1;\n");
  const Outcome outcome = scene.run({"solve", "f.phc", "--json", "/dev/full"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "moivre: cannot write /dev/full: No space left on device\n");
}

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("json", "json"), 0U);
  EXPECT_EQ(edit_distance("jsn", "json"), 1U);
  EXPECT_EQ(edit_distance("jsoon", "json"), 1U);
  EXPECT_EQ(edit_distance("jzon", "json"), 1U);
  EXPECT_EQ(edit_distance("slove", "solve"), 1U);
  EXPECT_EQ(edit_distance("", "json"), 4U);
}

}  // namespace
}  // namespace moivre::test
