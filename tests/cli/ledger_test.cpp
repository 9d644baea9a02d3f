// SPDX-License-Identifier: MIT
// Does a run that is kept in a ledger survive kill -9 at any moment, and everything else that
// befalls files? A hundred kills, of runs of a fraction of a second; bench/kills has longer ones.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "problems.h"
#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// But for what the clock has to do with.
std::string without_times(const std::string& text) {
  Json json = Json::parse(text);
  json.erase("time_s");
  return json.dump();
}

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The call, killed so many times after up to so many milliseconds, and then left alone: its JSON.
std::string killed_and_resumed(const Scene& scene, const Words& call, unsigned seed, int kills,
                               int longest) {
  std::mt19937 random(seed);
  const Words kept = with(call, {"--quiet", "--json", "k.json", "--ledger", "k.db"});
  for (const char* file : {"k.db", "k.db-wal", "k.db-shm"}) {
    std::filesystem::remove(scene.path(file));
  }
  for (int k = 0; k < kills; ++k) {
    scene.run(kept, false, [&](int process) {
      ::usleep(static_cast<useconds_t>(1000 * (random() % static_cast<unsigned>(longest))));
      ::kill(process, SIGKILL);
    });
  }
  const Outcome outcome = scene.run(kept);
  EXPECT_EQ(outcome.err, "");
  return without_times(scene.read("k.json"));
}

/// Of several seeds of the moments.
void expect_the_same_after_kills(const Scene& scene, const Words& call, int kills, int longest) {
  scene.run(with(call, {"--quiet", "--json", "base.json"}));
  const std::string base = without_times(scene.read("base.json"));
  for (const unsigned seed : {1U, 2U, 3U}) {
    EXPECT_EQ(killed_and_resumed(scene, call, seed, kills, longest), base) << seed;
  }
}

TEST(KeptRun, ASolveThatIsKilledGoesOnToTheSameBytes) {
  const Scene scene;
  scene.write("f.phc", cyclic(6));
  const Words call{"solve", "f.phc", "--start", "total-degree"};
  expect_the_same_after_kills(scene, with(call, {"--tracker", "lanes", "--threads", "2"}), 6, 250);
  expect_the_same_after_kills(scene, with(call, {"--tracker", "cvode", "--threads", "1"}), 4, 600);
}

TEST(KeptRun, ClosuresThatAreKilledGoOnToTheSameBytes) {
  const Scene scene;
  expect_the_same_after_kills(
      scene, {"closures", MOIVRE_SOURCE_DIR "/problems/mechanisms/octahedral-3-3.toml"}, 4, 400);
}

TEST(KeptRun, ASweepThatIsKilledGoesOnToTheSameBytes) {
  const Scene scene;
  expect_the_same_after_kills(scene,
                              {"sweep", MOIVRE_SOURCE_DIR "/problems/mechanisms/3-rpr.toml",
                               "--vary", "leg 1.length=8:24:6", "--vary", "leg 2.length=8:24:6"},
                              4, 400);
}

TEST(KeptRun, AMotionThatIsKilledGoesOnToTheSameBytes) {
  const Scene scene;
  expect_the_same_after_kills(
      scene, {"motion", MOIVRE_SOURCE_DIR "/problems/mechanisms/jansen-leg.toml"}, 4, 300);
}

TEST(KeptRun, PosesThatAreKilledGoOnToTheSameBytes) {
  const Scene scene;
  std::mt19937 random(1);
  const auto part = [&] { return std::to_string(static_cast<int>(random() % 1000) - 500) + "e-3"; };
  std::string poses = "x,y,z,qw,qx,qy,qz\n";
  for (int k = 0; k < 300; ++k) {
    const std::string place = part() + ',' + part() + ',' + part();
    poses += place + (k % 2 == 0 ? ",0.5,-0.5,0.5,0.5\n" : ",0.1,0.7,-0.1,0.7\n");
  }
  scene.write("poses.csv", poses);
  expect_the_same_after_kills(
      scene,
      {"closures", MOIVRE_SOURCE_DIR "/problems/robots/kinova_j2s6s200.urdf", "--tip",
       "j2s6s200_end_effector", "--poses", "poses.csv"},
      4, 250);
}

/// Three quadrics in three unknowns with twelve parameters, and members of them.
void write_family(const Scene& scene, int members) {
  std::string parameters, table;
  std::string text = "3 15\n";
  for (int i = 1; i <= 3; ++i) {
    text += std::to_string(i) + "*x^2 + " + std::to_string(5 - i) + "*y^2 - z^2 + x*y";
    for (const char* name : {"x", "y", "z", ""}) {
      const std::string p = std::string("p") + std::to_string(i) + (*name == 0 ? "1" : name);
      parameters += (parameters.empty() ? "" : ",") + p;
      text += " + " + p + (*name == 0 ? "" : std::string("*") + name);
    }
    text += ";\n";
  }
  scene.write("f.phc", text);
  std::mt19937 random(1);
  table = parameters + '\n';
  for (int k = 0; k < members; ++k) {
    for (int j = 0; j < 12; ++j) {
      table +=
          (j == 0 ? "" : ",") + std::to_string(static_cast<int>(random() % 1000) - 500) + "e-2";
    }
    table += '\n';
  }
  scene.write("t.csv", table);
  scene.write("parameters", parameters);
}

TEST(KeptRun, AFamilyThatIsKilledGoesOnToTheSameBytes) {
  const Scene scene;
  write_family(scene, 1500);
  const Words learn{"family",      "learn", "f.phc",   "--parameters", scene.read("parameters"),
                    "--monodromy", "-o",    "f.family"};
  expect_the_same_after_kills(scene, learn, 3, 100);
  const std::string family = scene.read("f.family");
  scene.run(with(learn, {"--quiet"}));
  EXPECT_EQ(scene.read("f.family"), family);
  expect_the_same_after_kills(
      scene, {"family", "solve", "f.family", "--table", "t.csv", "--tracker", "lanes"}, 4, 300);
}

/// Three processes that hear nothing of one another, and one that goes on from what they have kept.
void expect_the_same_of_parts(const Words& call, const Scene& scene) {
  Words merge{"ledger", "merge", "whole.db"};
  for (const std::string part : {"1", "2", "3"}) {
    const std::string file = "part" + part + ".db";
    const Outcome outcome =
        scene.run(with(call, {"--ledger", file, "--part", part + "/3", "--json", "part.json"}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "part " + part + " of 3 is kept in " + file)) << outcome.out;
    EXPECT_FALSE(scene.has("part.json"));
    merge.push_back(file);
  }
  const Outcome merged = scene.run(merge);
  EXPECT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_TRUE(contains(merged.out, "whole.db: moivre " + call.front())) << merged.out;
  scene.run(with(call, {"--quiet", "--ledger", "whole.db", "--json", "merged.json"}));
  scene.run(with(call, {"--quiet", "--json", "alone.json"}));
  EXPECT_EQ(without_times(scene.read("merged.json")), without_times(scene.read("alone.json")));
}

// More paths than are followed in one block.
TEST(KeptRun, PartsOfASolveAreTogetherTheBytesOfTheWhole) {
  const Scene scene;
  scene.write("f.phc", cyclic(7));
  expect_the_same_of_parts({"solve", "f.phc", "--start", "total-degree", "--tracker", "lanes"},
                           scene);
}

TEST(KeptRun, PartsOfATableAreTogetherTheBytesOfTheWhole) {
  const Scene scene;
  write_family(scene, 60);
  scene.run({"family", "learn", "f.phc", "--parameters", scene.read("parameters"), "--monodromy",
             "-o", "f.family"});
  expect_the_same_of_parts(
      {"family", "solve", "f.family", "--table", "t.csv", "--tracker", "lanes"}, scene);
}

TEST(KeptRun, PartsOfASweepAreTogetherTheBytesOfTheWhole) {
  const Scene scene;
  expect_the_same_of_parts({"sweep", MOIVRE_SOURCE_DIR "/problems/mechanisms/3-rpr.toml", "--vary",
                            "leg 1.length=8:24:6", "--vary", "leg 2.length=8:24:6"},
                           scene);
}

TEST(KeptRun, APartThatIsNoneIsRefused) {
  const Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  for (const char* part : {"3/2", "0/2", "1", "1/", "/2", "1/2x"}) {
    const Outcome outcome = scene.run({"solve", "f.phc", "--ledger", "r.db", "--part", part});
    EXPECT_EQ(outcome.exit_code, 1) << part;
    EXPECT_TRUE(contains(outcome.err, std::string(part) + " is no part: 2/5 is the second of five"))
        << outcome.err;
  }
  const Outcome lost = scene.run({"solve", "f.phc", "--part", "1/2"});
  EXPECT_EQ(lost.exit_code, 1);
  EXPECT_TRUE(contains(lost.err, "give --ledger PATH, another one for each part")) << lost.err;
}

// Of the first block the part is done when the run is ended.
TEST(KeptRun, APartThatIsInterruptedIsNotToldAsDone) {
  const Scene scene;
  scene.write("f.phc", cyclic(8));
  const Words call{"solve", "f.phc",    "--start", "total-degree", "--tracker",
                   "lanes", "--ledger", "part.db", "--part",       "1/2"};
  const Outcome outcome = scene.run(with(call, {"--threads", "1", "--time-limit", "0.7"}));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_FALSE(contains(outcome.out, "is kept in part.db")) << outcome.out;
  EXPECT_TRUE(contains(outcome.err, "the time limit of 0.7 s was reached")) << outcome.err;
}

// There is nothing to share.
TEST(KeptRun, APartOfShortWorkIsAllOfIt) {
  const Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Words json{"--quiet", "--json", "r.json"};
  EXPECT_EQ(
      scene.run(with({"solve", "f.phc", "--ledger", "r.db", "--part", "2/2"}, json)).exit_code, 0);
  const std::string part = without_times(scene.read("r.json"));
  scene.run(with({"solve", "f.phc"}, json));
  EXPECT_EQ(part, without_times(scene.read("r.json")));
}

TEST(KeptRun, AFinishedRunIsToldAgainAsItWas) {
  const Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Words call{"solve", "f.phc", "--ledger", "r.db", "--json", "r.json", "--csv", "r.csv"};
  const Outcome first = scene.run(call);
  const std::string json = scene.read("r.json"), csv = scene.read("r.csv");
  std::filesystem::remove(scene.path("r.json"));
  std::filesystem::remove(scene.path("r.csv"));
  const Outcome again = scene.run(call);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(scene.read("r.json"), json);  // its times too
  EXPECT_EQ(scene.read("r.csv"), csv);
  // What it did not write follows from what it has observed.
  EXPECT_EQ(scene.run(with(call, {"--all", "--phc", "r.phc"})).exit_code, 0);
  EXPECT_EQ(without_times(scene.read("r.json")), without_times(json));
  EXPECT_TRUE(scene.has("r.phc"));
}

TEST(KeptRun, ALedgerTellsHowItsRunStands) {
  const Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome first = scene.run({"solve", "f.phc", "--ledger", "r.db", "--json", "r.json"});
  const Outcome told = scene.run({"ledger", "r.db"});
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_TRUE(contains(told.out, "r.db: moivre solve, finished with exit code 0\n")) << told.out;
  EXPECT_TRUE(contains(told.out, "4 finite, 0 at infinity, 0 failed\n\n" + first.out)) << told.out;
  EXPECT_EQ(scene.run({"ledger", "r.db", "--result", "-"}).out, scene.read("r.json"));
  const Outcome none = scene.run({"ledger", "f.phc"});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_TRUE(contains(none.err, "f.phc")) << none.err;
}

TEST(KeptRun, ARunThatIsInterruptedIsToldAsSuchAndGoesOn) {
  const Scene scene;
  scene.write("f.phc", katsura(12));
  const Words call{"solve", "f.phc", "--quiet", "--ledger", "r.db", "--json", "r.json"};
  EXPECT_EQ(scene.run(with(call, {"--time-limit", "0.5"})).exit_code, 2);
  const Outcome told = scene.run({"ledger", "r.db"});
  EXPECT_EQ(told.exit_code, 2);
  EXPECT_TRUE(contains(told.out, "interrupted; the same command goes on")) << told.out;
  EXPECT_EQ(scene.run({"ledger", "r.db", "--result", "x.json"}).exit_code, 1);
  EXPECT_FALSE(scene.has("x.json"));
}

TEST(KeptRun, AnotherRunIsRefusedWithWhatDiffers) {
  const Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  scene.write("g.phc", kParallelLines);
  scene.run({"solve", "f.phc", "--ledger", "r.db"});
  const Outcome seed = scene.run({"solve", "f.phc", "--seed", "2", "--ledger", "r.db"});
  EXPECT_EQ(seed.exit_code, 1);
  EXPECT_EQ(seed.err, "moivre: r.db is the ledger of another run: --seed was 1 and is 2\n");
  const Outcome file = scene.run({"solve", "g.phc", "--ledger", "r.db"});
  EXPECT_EQ(file.exit_code, 1);
  EXPECT_TRUE(contains(file.err, "another run: fingerprint of the file was ")) << file.err;
  EXPECT_EQ(scene.run({"solve", "-", "--ledger", "r.db"}).exit_code, 1);
  EXPECT_EQ(scene.run({"solve", "f.phc", "--ledger", "f.phc"}).exit_code, 1);
  EXPECT_EQ(scene.read("f.phc"), kCircleAndHyperbola);
}

/// While it lives no file of this process, and of those that it begins, may be larger.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const struct rlimit limit { bytes, before_.rlim_max };
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

 private:
  struct rlimit before_ = {};
};

TEST(KeptRun, WhereTheLedgerHasNoMoreRoomTheRunEndsWithWhatItHas) {
  const Scene scene;
  scene.write("f.phc", katsura(12));
  const Words call{"solve",    "f.phc", "--quiet", "--tracker", "lanes",
                   "--ledger", "r.db",  "--json",  "r.json"};
  Outcome outcome;
  {
    const FileLimit limit(rlim_t{300'000});
    // Its JSON has to be shorter than that: it goes where no limit is.
    outcome = scene.run({"solve", "f.phc", "--quiet", "--tracker", "lanes", "--ledger", "r.db"});
  }
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "the ledger r.db cannot be written any more")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "what was committed before stands")) << outcome.err;
  EXPECT_EQ(scene.run(call).exit_code, 0);
  EXPECT_EQ(Json::parse(scene.read("r.json"))["solutions"].size(), 4096);
}

}  // namespace
}  // namespace moivre::test
