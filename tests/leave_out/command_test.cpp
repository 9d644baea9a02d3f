// SPDX-License-Identifier: MIT
// Does a run over polynomials leave TOML alone, and with the lanes SUNDIALS? The command line, run
// inside this program.
#include <gtest/gtest.h>

#include <fstream>

#include "command_line.h"
#include "counted_packages.h"
#include "moivre/closures/closures.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/mechanism/read.h"
#include "moivre/solver/solve.h"

namespace moivre {
namespace {

const std::string kProblems = MOIVRE_SOURCE_DIR "/problems";

struct Calls {
  int toml_files = test::Counted<&read_mechanism>::calls();
  int sundials_contexts = test::SundialsContexts::calls();
  int thread_pools = test::ThreadPools::calls();
  int closure_searches = test::Counted<&find_closures>::calls();
  int solves = test::Counted<&solve>::calls();
  int ranks = test::Counted<&constraint_rank>::calls();
};

/// The calls that a command made; it must decide everything.
Calls calls_of(std::vector<std::string> words) {
  words.insert(words.begin(), "moivre");
  words.push_back("--quiet");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  const Calls before;
  EXPECT_EQ(run_command_line(static_cast<int>(arguments.size()), arguments.data()), kDecided);
  const Calls after;
  return {after.toml_files - before.toml_files,
          after.sundials_contexts - before.sundials_contexts,
          after.thread_pools - before.thread_pools,
          after.closure_searches - before.closure_searches,
          after.solves - before.solves,
          after.ranks - before.ranks};
}

TEST(LeaveOut, APolynomialRunReadsNoToml) {
  const std::string file = kProblems + "/polynomials/katsura-5.phc";
  for (const std::string command : {"solve", "info", "newton", "guesses"}) {
    EXPECT_EQ(calls_of({command, file}).toml_files, 0) << command;
  }
  EXPECT_EQ(calls_of({"mobility", kProblems + "/mechanisms/four-bar.toml"}).toml_files, 1);
}

TEST(LeaveOut, TheCommandWithLanesInitializesNothingOfSundials) {
  const std::string file = kProblems + "/polynomials/katsura-5.phc";
  EXPECT_EQ(calls_of({"solve", file, "--tracker", "lanes"}).sundials_contexts, 0);
  EXPECT_GT(calls_of({"solve", file, "--tracker", "cvode"}).sundials_contexts, 0);
  const std::string four_bar = kProblems + "/mechanisms/four-bar.toml";
  EXPECT_EQ(calls_of({"closures", four_bar, "--tracker", "lanes"}).sundials_contexts, 0);
  EXPECT_EQ(calls_of({"motion", four_bar, "--tracker", "lanes"}).sundials_contexts, 0);
}

TEST(LeaveOut, TheCommandOnFourPathsOpensNoThreadPool) {
  const std::string four_paths = testing::TempDir() + "moivre-four-paths.phc";
  std::ofstream(four_paths) << "2\nx^2 + y^2 - 5;\nx*y - 2;\n";
  EXPECT_EQ(calls_of({"solve", four_paths, "--threads", "4"}).thread_pools, 0);
  const std::string many_paths = kProblems + "/polynomials/katsura-5.phc";
  EXPECT_GT(calls_of({"solve", many_paths, "--threads", "4"}).thread_pools, 0);
}

TEST(LeaveOut, MobilityTracksNoPath) {
  const Calls calls = calls_of({"mobility", kProblems + "/mechanisms/four-bar.toml"});
  EXPECT_EQ(calls.sundials_contexts, 0);
  EXPECT_EQ(calls.solves, 0);
  EXPECT_EQ(calls_of({"solve", kProblems + "/polynomials/katsura-5.phc"}).solves, 1);
}

TEST(LeaveOut, RanksOfConstraintsAreFoundForJsonOnly) {
  const std::string four_bar = kProblems + "/mechanisms/four-bar.toml";
  EXPECT_EQ(calls_of({"closures", four_bar}).ranks, 0);
  EXPECT_EQ(calls_of({"motion", four_bar, "--steps", "4"}).ranks, 0);
  EXPECT_EQ(calls_of({"closures", four_bar, "--json", "/dev/null"}).ranks, 1);
}

TEST(LeaveOut, TheCommandForMotionFromAGuessSolvesNoPolynomials) {
  const std::string four_bar = kProblems + "/mechanisms/four-bar.toml";
  for (const std::vector<std::string>& given :
       {std::vector<std::string>{"--from-guess"}, {"--guess", "coupler.phi=-60"}}) {
    std::vector<std::string> words{"motion", four_bar, "--to", "0.1", "--steps", "4"};
    words.insert(words.end(), given.begin(), given.end());
    const Calls calls = calls_of(words);
    EXPECT_EQ(calls.closure_searches, 0);
    EXPECT_EQ(calls.solves, 0);
    EXPECT_EQ(calls.sundials_contexts, 0);
    EXPECT_EQ(calls.thread_pools, 0);
  }
  EXPECT_GT(calls_of({"motion", four_bar, "--to", "0.1", "--steps", "4"}).closure_searches, 0);
}

}  // namespace
}  // namespace moivre
