// SPDX-License-Identifier: MIT
// Does `moivre solve` keep its contract: roots, exit codes, outputs, refusals?
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "problems.h"
#include "program.h"
#include "refusing.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

TEST(SolveCommand, PrintsTheRootsOfAFile) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run({"solve", "f.phc"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(contains(outcome.out,
                       "f.phc: 2 equations in 2 unknowns, degrees 2 2, total degree 4\n"
                       "4 paths (total-degree, cvode, seed 1): 4 finite, 0 at infinity, 0 failed\n"
                       "4 isolated roots: 4 real, 0 not real\n"))
      << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "  x =  1\n  y =  2\n")) << outcome.out;
}

TEST(SolveCommand, WritesNothingButJsonToStandardOutputWhenAsked) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run({"solve", "f.phc", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["solutions"].size(), 4U);
  EXPECT_EQ(json["complete"], true);
  const Json& time = json["time_s"];
  EXPECT_GT(time["parse"].get<double>(), 0);
  EXPECT_GE(time["total"].get<double>(), time["parse"].get<double>() + time["track"].get<double>());
}

TEST(SolveCommand, GivesTheSameBytesForEveryNumberOfThreads) {
  Scene scene;
  scene.write("f.phc", katsura(6));
  std::string first;
  for (const char* threads : {"1", "2", "7", "64"}) {
    const Outcome outcome = scene.run({"solve", "f.phc", "--threads", threads, "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    const std::string bytes = outcome.out.substr(0, outcome.out.find("\"time_s\""));
    if (first.empty()) first = bytes;
    EXPECT_EQ(bytes, first) << threads << " threads";
    EXPECT_EQ(Json::parse(outcome.out)["time_s"]["threads"], std::stoi(threads));
  }
}

TEST(SolveCommand, CountsNoCertificatesWhereNoRootIsRegular) {
  Scene scene;
  scene.write("f.txt", "x*y = 1\nx*y*z = z\nx = y\n");
  const Outcome told = scene.run({"solve", "f.txt"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "\nno regular root to certify: completeness ")) << told.out;
}

TEST(SolveCommand, TellsTheRootsThatMeetConditions) {
  Scene scene;
  scene.write("f.txt", "x^2 + y^2 = 5\nx*y = 2\nx > 0\nx*y <= 2\n");  // +-(1, 2), +-(2, 1)
  const Outcome told = scene.run({"solve", "f.txt", "--where", "x < y", "--where", "0 < y <= 7"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "1 isolated root: 1 real, 0 not real; 3 more were not asked for"))
      << told.out;
  EXPECT_TRUE(contains(told.out, ", on the boundary of x*y <= 2\n  x =  1\n  y =  2\n"))
      << told.out;
  if (MOIVRE_WITH_CERTIFY) {
    EXPECT_TRUE(contains(told.out, "\n1 root and 3 left out, 4 = total degree: proved complete\n"))
        << told.out;
  }
  const Json json = Json::parse(scene.run({"solve", "f.txt", "--json", "-"}).out);
  EXPECT_EQ(json["filtered"], 2);
  EXPECT_EQ(json["solutions"][0]["on_boundary"], Json({"x*y <= 2"}));
  const Outcome open = scene.run({"solve", "f.txt", "--where", "x*y > 2"});
  EXPECT_TRUE(contains(open.out, "2 of them on its boundary as far as digits tell")) << open.out;
  const Outcome guesses = scene.run({"guesses", "f.txt", "--json", "-"});
  EXPECT_EQ(Json::parse(guesses.out)["guesses"].size(), 2U);
}

TEST(SolveCommand, RefusesWhatIsNoConditionWithACaret) {
  Scene scene;
  scene.write("f.txt", "x^2 = 5\n");
  const Outcome outcome = scene.run({"solve", "f.txt", "--where", "x > z"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "--where:1:5: error: `z` occurs in this condition"))
      << outcome.err;
}

#if MOIVRE_WITH_MULTIPRECISION

// Roots 2e-20 apart: Newton's method comes to the same one of them twice.
TEST(SolveCommand, GivesTheDigitsOfRootsThatDoubleDoesNotTellApart) {
  if (!MOIVRE_WITH_CERTIFY) GTEST_SKIP() << "needs more digits";
  Scene scene;
  scene.write("f.phc", "1\n((x - 1/3)^2 - 1e-40)*(x - 2);\n");
  const Outcome outcome = scene.run({"solve", "f.phc", "--digits", "30", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json["solutions"].size(), 3U);
  std::set<std::string> roots;
  for (const Json& root : json["solutions"]) roots.insert(root["x_digits"][0][0]);
  EXPECT_EQ(roots, (std::set<std::string>{"0.333333333333333333323333333333",
                                          "0.333333333333333333343333333333",
                                          "2.00000000000000000000000000000"}));
}

TEST(SolveCommand, GivesAsManyDigitsAsAreAskedFor) {
  Scene scene;
  scene.write("f.phc", "1\nx^2 - 2;\n");
  const std::string digits = "1.4142135623730950488016887242096980785696718753769";
  EXPECT_TRUE(
      contains(scene.run({"solve", "f.phc", "--digits", "50"}).out, "\n  x =  " + digits + "\n"));
  const Outcome outcome =
      scene.run({"solve", "f.phc", "--digits", "50", "--json", "-", "--csv", "f.csv"});
  EXPECT_EQ(outcome.exit_code, 0);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["digits"], 50);
  std::set<std::string> roots;
  for (const Json& solution : json["solutions"]) {
    roots.insert(solution["x_digits"][0][0]);
    EXPECT_EQ(solution["x_digits"][0][1], "0");
  }
  EXPECT_EQ(roots, (std::set<std::string>{digits, "-" + digits}));
  std::istringstream table(scene.read("f.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_TRUE(line.ends_with(",x.re,x.im")) << line;
  std::set<std::string> rows;
  while (std::getline(table, line)) rows.insert(line.substr(line.rfind(',', line.rfind(',') - 1)));
  EXPECT_EQ(rows, (std::set<std::string>{"," + digits + ",0", ",-" + digits + ",0"}));
}

TEST(SolveCommand, SaysThatASingularRootHasNoDigits) {
  Scene scene;
  scene.write("f.phc", "1\nx^3 - 4*x^2 + 5*x - 2;\n");  // (x - 1)^2 (x - 2)
  const Outcome outcome = scene.run({"solve", "f.phc", "--digits", "30", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json["solutions"].size(), 2U);
  for (const Json& solution : json["solutions"]) {
    EXPECT_EQ(solution["x_digits"].is_null(), solution["singular"].get<bool>());
  }
  EXPECT_EQ(json["left_out"].back()["what"], "30 digits of 1 root");
}

TEST(SolveCommand, RefusesNumbersOfDigitsOutOfRange) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  for (const char* digits : {"0", "-3", "1001"}) {
    const Outcome outcome = scene.run({"solve", "f.phc", "--digits", digits});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err, std::string("moivre: --digits ") + digits +
                               ": the number of digits must lie between 1 and 1000\n");
  }
}

#else

TEST(SolveCommand, SaysThatItWasBuiltWithoutDigits) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run({"solve", "f.phc", "--digits", "30"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "without multiprecision")) << outcome.err;
}

#endif

TEST(SolveCommand, FindsTheSameRootsWithEveryMethodAndSeed) {
  Scene scene;
  scene.write("f.phc", katsura(4));
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--method", "bdf", "--rtol", "1e-6"},
        {"--method", "adams", "--rtol", "1e-6"},
        {"--seed", "18446744073709551615"}}) {
    std::vector<std::string> arguments = {"solve", "f.phc", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = scene.run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << options[1];
    EXPECT_EQ(Json::parse(outcome.out)["solutions"].size(), 16U) << options[1];
  }
}

TEST(SolveCommand, WritesAllFormsAtOnce) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run(
      {"solve", "f.phc", "--quiet", "--json", "f.json", "--csv", "f.csv", "--phc", "f.roots"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_EQ(Json::parse(scene.read("f.json"))["solutions"].size(), 4U);
  const std::string table = scene.read("f.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "path,real,singular,multiplicity,residual,accuracy,condition,x.re,x.im,y.re,y.im");
  EXPECT_TRUE(contains(scene.read("f.roots"), "\nTHE SOLUTIONS :\n4 2\n"));
}

TEST(SolveCommand, ListsEveryPathAndItsRoot) {
  Scene scene;
  scene.write("two.phc", "2\n x^2 - 1;\n (x - 1)*y^2 - y;\n");
  const Outcome outcome = scene.run(
      {"solve", "two.phc", "--start", "total-degree", "--json", "-", "--paths", "paths.csv"});
  const auto json = Json::parse(outcome.out);
  std::istringstream table(scene.read("paths.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line,
            "path,stage,verdict,solution,reason,precision,followed,handed_over,steps,by_count");
  std::uint64_t path = 0;
  std::vector<std::uint64_t> to(json["solutions"].size());
  std::map<std::string, std::uint64_t> ends;
  for (; std::getline(table, line); ++path) {
    EXPECT_EQ(line.substr(0, line.find(',')), std::to_string(path));
    std::istringstream cells(line);
    std::string cell;
    for (int k = 0; k < 3; ++k) std::getline(cells, cell, ',');
    ++ends[cell];
    std::getline(cells, cell, ',');
    if (!cell.empty()) ++to.at(std::stoul(cell));
  }
  EXPECT_EQ(path, json["paths"]["tracked"]);
  EXPECT_EQ(ends["finite"], json["paths"]["finite"]);
  for (std::size_t k = 0; k < to.size(); ++k)
    EXPECT_EQ(to[k], json["solutions"][k]["multiplicity"]);
}

TEST(SolveCommand, CallsItDecidedThatParallelLinesHaveNoRoot) {
  Scene scene;
  scene.write("f.phc", kParallelLines);
  const Outcome outcome = scene.run({"solve", "f.phc", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  const Json json = Json::parse(outcome.out);
  EXPECT_TRUE(json["solutions"].empty());
  EXPECT_EQ(json["complete"], true);
  EXPECT_TRUE(contains(scene.run({"solve", "f.phc"}).out,
                       "no path to track\n"
                       "0 isolated roots: 0 real, 0 not real\n"
                       "the equations contradict each other: no root\n"));
}

TEST(SolveCommand, ExitsWithTwoAndNamesThePathsThatFailed) {
  Scene scene;
  // Exact algebra finds the roots where the coefficients are real.
  scene.write("f.phc", "2\nx^2 + y^2 - 5;\ni*x*y - 2;\n");
  const Outcome outcome = scene.run({"solve", "f.phc", "--max-steps", "2", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 2);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["paths"]["failed"], 4);
  ASSERT_EQ(json["failures"].size(), 4U);
  EXPECT_EQ(json["failures"][0]["reason"], "step limit");
}

TEST(SolveCommand, RefusesAnUnderdeterminedSystemWithoutJson) {
  Scene scene;
  scene.write("under.phc", "1 2\nx*y - 1;\n");
  const Outcome outcome = scene.run({"solve", "under.phc", "--json", "f.json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.ends_with(
      ": it is underdetermined: its roots form sets of dimension 1 or more, and none is isolated. "
      "moivre solve --slice cuts them by random linear equations\n"))
      << outcome.err;
  EXPECT_FALSE(scene.has("f.json"));
}

TEST(SolveCommand, GreekNamesStandInTheSameColumnAsOthers) {
  Scene scene;
  scene.write("greek.phc", "\u03b1 = 2\nx[1] = 3\n");
  const Outcome outcome = scene.run({"solve", "greek.phc"});
  EXPECT_NE(outcome.out.find("\n  \u03b1    =  2\n  x[1] =  3\n"), std::string::npos)
      << outcome.out;
}

TEST(SolveCommand, CountsTheRootsThatSquaringUpAdded) {
  Scene scene;
  scene.write("over.phc", "2 1\nx^2 - 1;\nx - 1;\n");
  const Outcome outcome = scene.run({"solve", "over.phc", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["excess"], 1);
  EXPECT_EQ(json["solutions"].size(), 1U);
}

TEST(SolveCommand, NamesTheLineOfAFault) {
  Scene scene;
  scene.write("f.phc", "2\nx^2 + (y - 5;\nx*y - 2;\n");
  const Outcome outcome = scene.run({"solve", "f.phc", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err,
            "f.phc:2:7: error: unbalanced parenthesis: this `(` is never closed\n"
            "    x^2 + (y - 5;\n"
            "          ^\n");
}

TEST(SolveCommand, RefusesAFileThatIsNotThere) {
  const Outcome outcome = Scene().run({"solve", "absent.phc"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "moivre: absent.phc: cannot be opened: No such file or directory\n");
}

TEST(SolveCommand, FindsAnUnwritableOutputBeforeItSolves) {
  Scene scene;
  scene.write("f.phc", katsura(12));
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome = scene.run({"solve", "f.phc", "--json", "no/such/folder.json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "moivre: cannot write no/such/folder.json: No such file or directory\n");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

TEST(SolveCommand, LeavesAnOldResultAloneWhenItRefuses) {
  Scene scene;
  scene.write("under.phc", "1 2\nx*y - 1;\n");
  scene.write("old.json", "old");
  EXPECT_EQ(scene.run({"solve", "under.phc", "--json", "old.json"}).exit_code, 1);
  EXPECT_EQ(scene.read("old.json"), "old");
}

TEST(SolveCommand, ReplacesALongerOldResult) {
  Scene scene;
  scene.write("f.phc", kParallelLines);
  scene.write("old.json", std::string(100000, 'x'));
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "old.json"}).exit_code, 0);
  EXPECT_TRUE(Json::accept(scene.read("old.json")));
}

TEST(SolveCommand, WillNotOverwriteTheProblemOrMixTwoResults) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "./f.phc"}).exit_code, 1);
  EXPECT_EQ(scene.read("f.phc"), kCircleAndHyperbola);
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "-", "--csv", "-"}).exit_code, 1);
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "a", "--csv", "a"}).exit_code, 1);
}

TEST(SolveCommand, RefusesEachWrongOptionWithItsReason) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const std::vector<Refusal> refusals = {
      {{"--tracker", "lanes", "--tolerance", "0"}, "tolerance must lie in (0, 0.1]"},
      {{"--tracker", "magic"}, "--tracker magic: the trackers are cvode and lanes"},
      {{"--method", "adams_projection"},
       "--method adams_projection: CVODE projects with BDF only (\"CVodeSetProjFn: projection is "
       "only supported with BDF\"); take bdf_projection, or adams without projection"},
      {{"--method", "euler"}, "--method euler: the methods are bdf_projection, bdf and adams"},
      {{"--iteration", "halley"}, "--iteration halley: the iterations are fixed_point and newton"},
      {{"--start", "magic"},
       "--start magic: the start systems are auto, total-degree, multihomogeneous and polyhedral"},
      {{"--tracker", "lanes", "--predictor", "x"},
       "--predictor x: the predictors are tangent, cubic and quintic"},
      {{"--rtol", "0"}, "rtol must lie in (0, 0.5]"},
      {{"--rtol", "nan"}, "rtol must lie in (0, 0.5]"},
      {{"--max-steps", "0"}, "maximum_steps must be at least 1"},
      {{"--threads", "-1"}, "threads must lie between 0 (all cores) and 1024"},
      {{"--threads", "100000"}, "threads must lie between 0 (all cores) and 1024"},
      {{"--seed", "-1"}, "--seed: -1 is negative"},
      {{"--seed", "18446744073709551616"}, "--seed: 18446744073709551616 is beyond 64 bits"},
      {{"--seed", "x"}, "--seed takes a number, not x"},
      {{"--threads=two"}, "--threads takes a number, not two"},
      {{"--digits", "30x"}, "--digits takes a number, not 30x: write 30, without a unit"},
      {{"--start"}, "--start needs a value behind it"},
      {{"--jsn", "-"}, "unknown option --jsn; did you mean --json?"},
      {{"--html", "f.html"}, "unknown option --html"},
      {{"--tread=2"}, "unknown option --tread; did you mean --threads?"}};
  for (const Refusal& refusal : refusals) {
    std::vector<std::string> arguments = {"solve", "f.phc"};
    arguments.insert(arguments.end(), refusal.options.begin(), refusal.options.end());
    const Outcome outcome = scene.run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << refusal.options[0];
    EXPECT_EQ(outcome.out, "") << refusal.options[0];
    EXPECT_TRUE(has_line(outcome.err, "moivre: " + refusal.message)) << outcome.err;
  }
}

TEST(SolveCommand, NamesEveryWrongOptionAtOnce) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome =
      scene.run({"solve", "f.phc", "--start", "magic", "--threads", "-1", "--precision", "half",
                 "--method", "euler", "--iteration", "halley", "--rtol", "7", "--max-steps", "0"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "moivre: --start magic: the start systems are auto, total-degree, multihomogeneous and "
            "polyhedral\n"
            "moivre: threads must lie between 0 (all cores) and 1024\n"
            "moivre: --precision half: the precisions are auto, double and double-double\n"
            "moivre: --method euler: the methods are bdf_projection, bdf and adams\n"
            "moivre: --iteration halley: the iterations are fixed_point and newton\n"
            "moivre: rtol must lie in (0, 0.5]; maximum_steps must be at least 1\n");
}

TEST(SolveCommand, EndsOnCtrlCWithWhatIsFinished) {
  Scene scene;
  scene.write("f.phc", katsura(13));
  const Outcome outcome = scene.run_until({"solve", "f.phc", "--threads", "2", "--json", "-"},
                                          " of 8192 paths, ", SIGINT);
  EXPECT_EQ(outcome.exit_code, 2);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["message"], "interrupted: what is finished is reported");
  EXPECT_LT(json["paths"]["tracked"].get<int>(), 8192);
}

TEST(SolveCommand, ShowsProgressOnATerminalAndErasesIt) {
  Scene scene;
  scene.write("f.phc", katsura(13));
  const Outcome outcome = scene.run_until({"solve", "f.phc", "--threads", "1", "--json", "f.json"},
                                          " of 8192 paths, ", SIGTERM);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, " a second, ")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, " s left")) << outcome.err;
  EXPECT_EQ(outcome.err.substr(outcome.err.rfind('\r')), "\r\x1b[K");
}

TEST(SolveCommand, ShowsNoProgressWhenQuietOrNotOnATerminal) {
  Scene scene;
  scene.write("f.phc", katsura(13));
  for (const bool terminal : {true, false}) {
    std::vector<std::string> arguments = {"solve", "f.phc", "--threads", "1", "--json", "f.json"};
    if (terminal) arguments.push_back("--quiet");
    // Of one thread: no less time has passed.
    const Outcome outcome = scene.run(arguments, terminal, send_after(1.3, SIGINT));
    EXPECT_EQ(outcome.err, "");
  }
}

}  // namespace
}  // namespace moivre::test
