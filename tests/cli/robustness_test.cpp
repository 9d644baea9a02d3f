// SPDX-License-Identifier: MIT
// Does the program lose nothing when it is stopped, when it cannot write, and when it is called
// carelessly?
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "problems.h"
#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

std::string rest_of(std::ifstream& stream) {
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// No file of this process and its children grows beyond so many bytes.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit old_ = {};
};

TEST(Robustness, TellsTheRootsWhereTheFileCannotBeWritten) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome =
      scene.run({"solve", "f.phc", "--quiet", "--json", "/dev/full", "--csv", "roots.csv"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "moivre: cannot write /dev/full: No space left on device\n");
  EXPECT_TRUE(has_line(outcome.out, "4 isolated roots: 4 real, 0 not real")) << outcome.out;
  const std::string table = scene.read("roots.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "path,real,singular,multiplicity,residual,accuracy,condition,x.re,x.im,y.re,y.im");
}

/// 1024 roots.
std::string ten_squares() {
  std::string text = "10\n";
  for (int k = 0; k < 10; ++k) text += " x" + std::to_string(k) + "^2 - 1;\n";
  return text;
}

TEST(Robustness, TextsOfManyRootsAreTheSameWhereTheyAreWrittenAtOnce) {
  Scene scene;
  scene.write("f.phc", ten_squares());
  const auto written = [&](const std::string& threads) {
    const Outcome outcome =
        scene.run({"solve", "f.phc", "--tracker", "lanes", "--threads", threads, "--json", "r.json",
                   "--csv", "r.csv", "--paths", "paths.csv", "--phc", "r.phc"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(has_line(outcome.out, "1024 isolated roots: 1024 real, 0 not real"));
    Json json = Json::parse(scene.read("r.json"));
    json.erase("time_s");
    return std::vector{json.dump(), scene.read("r.csv"), scene.read("paths.csv"),
                       scene.read("r.phc")};
  };
  const std::vector<std::string> alone = written("1");
  EXPECT_EQ(written("2"), alone);
  EXPECT_EQ(written("8"), alone);
  EXPECT_FALSE(contains(scene.listing(), ".moivre-")) << scene.listing();
}

TEST(Robustness, OfManyTextsThatAreWrittenAtOnceOneThatFailsLosesNoOther) {
  Scene scene;
  scene.write("f.phc", ten_squares());
  const FileLimit limit(300'000);  // the CSV has fewer bytes, the others more
  const Outcome outcome =
      scene.run({"solve", "f.phc", "--tracker", "lanes", "--threads", "3", "--quiet", "--json",
                 "r.json", "--csv", "r.csv", "--phc", "r.phc"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "moivre: cannot write r.json: File too large\n"
            "moivre: cannot write r.phc: File too large\n");
  EXPECT_TRUE(has_line(outcome.out, "1024 isolated roots: 1024 real, 0 not real"));
  const std::string table = scene.read("r.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1025);
  EXPECT_FALSE(contains(scene.listing(), "r.json")) << scene.listing();
  EXPECT_FALSE(contains(scene.listing(), ".moivre-")) << scene.listing();
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

TEST(Robustness, LeavesTheOldFileWhereALongOneCannotBeFinished) {
  constexpr rlim_t kBytes = 1 << 20;  // the motion has four times as many
  Scene scene;
  scene.write("motion.json", "what was there");
  const FileLimit limit(kBytes);
  const Outcome outcome =
      scene.run({"motion", std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml",
                 "--steps", "1000", "--json", "motion.json", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "moivre: cannot write motion.json: File too large\n");
  EXPECT_EQ(scene.read("motion.json"), "what was there");
  EXPECT_FALSE(contains(scene.listing(), ".moivre-")) << scene.listing();
}

TEST(Robustness, LeavesTheOldFileOfTwoNamesWhereALongOneCannotBeFinished) {
  constexpr rlim_t kBytes = 1 << 20;
  Scene scene;
  scene.write("motion.json", "what was there");
  std::filesystem::create_hard_link(scene.path("motion.json"), scene.path("other.json"));
  const std::string four_bar =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
  {
    const FileLimit limit(kBytes);
    const Outcome outcome =
        scene.run({"motion", four_bar, "--steps", "1000", "--json", "motion.json", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err, "moivre: cannot write motion.json: File too large\n");
  }
  EXPECT_EQ(scene.read("motion.json"), "what was there");
  EXPECT_EQ(scene.run({"motion", four_bar, "--json", "motion.json", "--quiet"}).exit_code, 0);
  EXPECT_EQ(scene.read("other.json"), scene.read("motion.json"));
  EXPECT_TRUE(Json::accept(scene.read("other.json")));
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
  scene.write("f.phc", katsura(8));
  const Outcome outcome =
      scene.run({"solve", "f.phc", "--threads", "1", "--digits", "1000", "--json", "-"}, false,
                send_after(1, SIGINT));
  EXPECT_EQ(outcome.exit_code, 2);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["complete"], false);
  EXPECT_FALSE(json["solutions"].empty());
  EXPECT_EQ(json["left_out"].back()["why"], "the run was interrupted before");
  EXPECT_EQ(outcome.err, "moivre: interrupted: what is finished is reported\n");
}
#endif

TEST(Robustness, AnInterruptedMotionDisputesNoCheckpoint) {
  const Scene scene;
  const std::string jansen =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/jansen-leg.toml";
  const Outcome outcome = scene.run({"motion", jansen, "--checkpoints", "10000", "--json", "-"},
                                    false, send_after(1, SIGINT));
  EXPECT_EQ(outcome.exit_code, 2);
  const Json motion = Json::parse(outcome.out);
  EXPECT_EQ(motion["complete"], false);
  EXPECT_EQ(motion["message"], "interrupted: what is finished is reported");
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
  const Outcome outcome =
      scene.run_until({"guesses", "f.phc", "--threads", "1"}, " of 8192 paths, ", SIGINT);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(has_line(outcome.out, "# not complete: interrupted: what is finished is reported"))
      << outcome.out.substr(0, 200);
}

TEST(Robustness, OneFileTakesOneResultByWhateverName) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  scene.write("points.csv", "1 0 1 0\n");
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "x", "--csv", "./x"}).err,
            "moivre: two results would go to ./x\n");
  EXPECT_FALSE(scene.has("x"));
  scene.write("x", "");
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "x", "--csv", "./x"}).exit_code, 1);
  EXPECT_EQ(scene
                .run({"track", "f.phc", "--path", "0", "--from", "f.phc", "--points", "points.csv",
                      "--csv", "points.csv"})
                .err,
            "moivre: the result would overwrite the problem file points.csv\n");
}

TEST(Robustness, ReadsStandardInput) {
  Scene scene;
  scene.write(Scene::kInput, kCircleAndHyperbola);
  const Outcome outcome = scene.run({"solve", "-", "--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out)["solutions"].size(), 4U);
  scene.write(Scene::kInput, "1\nx^2 - ;\n");
  EXPECT_TRUE(scene.run({"solve", "-"}).err.starts_with("standard input:2:6: error: "))
      << "names the input";
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
      {{"closures", "crank.toml", "--tolerance", "0.05"},
       "--tolerance: only the lanes take it (--tracker lanes); of dimensions it needs "
       "--sensitivity"},
      {{"solve", "f.phc", "--tolerance", "0.01"},
       "--tolerance: only the lanes take it (--tracker lanes)"},
      {{"track", "f.phc", "--path", "0", "--predictor", "x"},
       "--predictor: only the lanes take it (--tracker lanes)"},
      {{"solve", "crank.toml"},
       "crank.toml: this command takes polynomial systems; mechanisms (.toml) are for closures, "
       "motion, sweep, newton, mobility, guesses, study and family learn"},
      {{"motion", "crank.toml", "--threads", "-1", "--tracker", "x"},
       "threads must lie between 0 (all cores) and 1024"},
      {{"motion", "crank.toml", "--threads", "-1", "--tracker", "x"},
       "--tracker x: the trackers are cvode and lanes"}};
  for (const Careless& call : calls) {
    const Outcome outcome = scene.run(call.arguments);
    EXPECT_EQ(outcome.exit_code, 1) << call.message;
    EXPECT_EQ(outcome.out, "") << call.message;
    EXPECT_TRUE(has_line(outcome.err, "moivre: " + call.message)) << outcome.err;
  }
}

TEST(Robustness, TellsWhatTakesAPolynomialSystemInPlaceOfAMechanism) {
  Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run({"closures", "f.phc"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  const std::string line = outcome.err.substr(0, outcome.err.find('\n'));
  EXPECT_TRUE(line.ends_with(" (a mechanism is wanted; moivre solve takes a polynomial system)"))
      << outcome.err;
}

TEST(Robustness, SaysBeforehandThatAMotionIsTooLong) {
  const Scene scene;
  const std::string four_bar =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
  const Outcome outcome = scene.run({"motion", four_bar, "--to", "100"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "moivre: from t = 0 s to 100 s driver 'crank' turns 12335 times; a branch is followed "
            "for 3183 turns at most: take a nearer --to\n");
}

TEST(Robustness, SaysBeforehandThatSamplesWouldNotFitIntoMemory) {
  const Scene scene;
  const std::string four_bar =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
  const Outcome outcome = scene.run(
      {"motion", four_bar, "--steps", "1000000", "--json", "motion.json", "--csv", "motion.csv"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "moivre: --json: 1000000 steps would not fit into memory; take 370370 at most\n"
            "moivre: --csv: 1000000 steps would not fit into memory; take 370370 at most\n");
  const Outcome page = scene.run({"motion", four_bar, "--steps", "1000000", "--html", "m.html"});
  EXPECT_EQ(page.err,
            "moivre: --html: 1000000 steps would not fit into memory; take 37037 at most\n");
}

TEST(Robustness, NamesACountBeyondSixtyFourBitsByWhatIsKnown) {
  Scene scene;
  scene.write("f.phc", "99999999999999999999999\nx;\n");
  const Outcome outcome = scene.run({"solve", "f.phc"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      has_line(outcome.err, "f.phc:1:1: error: expected more than 1.8e19 polynomials, found 1:"))
      << outcome.err;
  EXPECT_TRUE(has_line(
      outcome.err,
      "f.phc:1:1: error: expected more than 1.8e19 unknowns, found 1 name: x (line 2, column 1)"))
      << outcome.err;
}

}  // namespace
}  // namespace moivre::test
