// SPDX-License-Identifier: MIT
// Does the program lose nothing when it is stopped, when it cannot write, and when it is called carelessly?
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>

#include "problems.h"
#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

std::string rest_of(std::ifstream& stream) {
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void interrupt_soon(int process) {
  ASSERT_TRUE(catches_interrupt(process));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  kill(process, SIGINT);
}

TEST(Robustness, TellsTheRootsWhereTheFileCannotBeWritten) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome =
      scene.run({"solve", "f.phc", "--quiet", "--json", "/dev/full", "--csv", "roots.csv"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "cannot write /dev/full: No space left")) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "4 isolated roots")) << outcome.out;
  EXPECT_TRUE(contains(scene.read("roots.csv"), "x.re")) << scene.read("roots.csv");
}

TEST(Robustness, PutsAWholeFileInTheOldOnesPlace) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  scene.write("old.json", "what was there");
  std::ifstream old(scene.path("old.json"));
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "old.json"}).exit_code, 0);
  EXPECT_EQ(rest_of(old), "what was there");
  EXPECT_EQ(Json::parse(scene.read("old.json"))["paths"]["finite"], 4);
  EXPECT_FALSE(contains(scene.listing(), ".moivre-")) << scene.listing();
}

TEST(Robustness, WritesThroughALink) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  std::filesystem::create_symlink("there.json", scene.path("link.json"));
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "link.json"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(scene.path("link.json")));
  EXPECT_EQ(Json::parse(scene.read("there.json"))["paths"]["finite"], 4);
}

#if MOIVRE_WITH_MULTIPRECISION
TEST(Robustness, InterruptedDigitsLeaveTheRoots) {
  Scene scene;
  scene.write("f.phc", katsura(9));
  const Outcome outcome =
      scene.run({"solve", "f.phc", "--threads", "1", "--digits", "1000", "--json", "-"}, false,
                interrupt_soon);
  EXPECT_EQ(outcome.exit_code, 2);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["complete"], false);
  EXPECT_FALSE(json["solutions"].empty());
  EXPECT_EQ(json["left_out"].back()["why"], "the run was interrupted before");
  EXPECT_TRUE(contains(outcome.err, "moivre: interrupted")) << outcome.err;
}
#endif

TEST(Robustness, AnInterruptedMotionDisputesNoCheckpoint) {
  const Scene scene;
  const std::string jansen =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/jansen-leg.toml";
  const Outcome outcome =
      scene.run({"motion", jansen, "--checkpoints", "10000", "--json", "-"}, false, interrupt_soon);
  EXPECT_EQ(outcome.exit_code, 2);
  const Json motion = Json::parse(outcome.out);
  EXPECT_EQ(motion["complete"], false);
  EXPECT_TRUE(contains(motion["message"], "interrupted: what is finished is reported"));
  std::size_t uncompared = 0;
  for (const Json& checkpoint : motion["checkpoints"]) {
    if (checkpoint["agrees"] == true) continue;
    EXPECT_EQ(checkpoint["message"], "interrupted before it was compared");
    ++uncompared;
  }
  EXPECT_GT(uncompared, 0U);
}

TEST(Robustness, InterruptedGuessesSayThatTheyAreNotAll) {
  Scene scene;
  scene.write("f.phc", katsura(13));
  const Outcome outcome = scene.run({"guesses", "f.phc", "--threads", "1"}, false, interrupt_soon);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.out, "# not complete: interrupted")) << outcome.out.substr(0, 200);
}

TEST(Robustness, OneFileTakesOneResultByWhateverName) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  scene.write("points.csv", "1 0 1 0\n");
  EXPECT_TRUE(contains(scene.run({"solve", "f.phc", "--json", "x", "--csv", "./x"}).err,
                       "two results would go to ./x"));
  EXPECT_FALSE(scene.has("x"));
  scene.write("x", "");
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "x", "--csv", "./x"}).exit_code, 1);
  EXPECT_TRUE(contains(scene
                           .run({"track", "f.phc", "--path", "0", "--from", "f.phc", "--points",
                                 "points.csv", "--csv", "points.csv"})
                           .err,
                       "would overwrite the problem file points.csv"));
}

TEST(Robustness, ReadsStandardInput) {
  Scene scene;
  scene.write(Scene::kInput, kCircleAndHyperbola);
  const Outcome outcome = scene.run({"solve", "-", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["solutions"].size(), 4U);
  scene.write(Scene::kInput, "1\nx^2 - ;\n");
  EXPECT_TRUE(contains(scene.run({"solve", "-"}).err, "standard input:2:")) << "names the input";
}

struct Careless {
  std::vector<std::string> arguments;
  std::string message;
};

TEST(Robustness, RefusesWhatWouldBeIgnored) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  scene.write("crank.toml", "[ground.points]\nO = [0, 0]\n");
  const std::vector<Careless> calls = {
      {{"solve", "f.phc", "--json", ""}, "an argument behind --json is empty"},
      {{"solve", "f.phc", "--seed="}, "--seed= is empty"},
      {{"solve", "f.phc", "--tolerance", "0.01"}, "--tolerance: only the lanes take it"},
      {{"track", "f.phc", "--path", "0", "--predictor", "x"}, "--predictor: only the lanes"},
      {{"solve", "crank.toml"}, "this command takes polynomial systems"},
      {{"closures", "f.phc"}, "moivre solve takes a polynomial system"},
      {{"motion", "crank.toml", "--threads", "-1", "--tracker", "x"}, "threads must lie between"},
      {{"motion", "crank.toml", "--threads", "-1", "--tracker", "x"}, "the trackers are cvode"}};
  for (const Careless& call : calls) {
    const Outcome outcome = scene.run(call.arguments);
    EXPECT_EQ(outcome.exit_code, 1) << call.message;
    EXPECT_EQ(outcome.out, "") << call.message;
    EXPECT_TRUE(contains(outcome.err, call.message)) << outcome.err;
  }
}

TEST(Robustness, SaysBeforehandThatAMotionIsTooLong) {
  const Scene scene;
  const std::string four_bar =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
  const Outcome outcome = scene.run({"motion", four_bar, "--to", "100"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "driver 'crank' turns 12335 times")) << outcome.err;
  EXPECT_FALSE(contains(outcome.err, "--from-guess")) << outcome.err;
}

TEST(Robustness, SaysBeforehandThatSamplesWouldNotFitIntoMemory) {
  const Scene scene;
  const std::string four_bar =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
  const Outcome outcome = scene.run(
      {"motion", four_bar, "--steps", "1000000", "--json", "motion.json", "--csv", "motion.csv"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "--json: 1000000 steps would not fit")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "--csv: 1000000 steps would not fit")) << outcome.err;
}

TEST(Robustness, NamesACountBeyondSixtyFourBitsByWhatIsKnown) {
  Scene scene;
  scene.write("f.phc", "99999999999999999999999\nx;\n");
  const Outcome outcome = scene.run({"solve", "f.phc"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "expected more than 1.8e19 polynomials")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "expected more than 1.8e19 unknowns")) << outcome.err;
}

}  // namespace
}  // namespace moivre::test
