// SPDX-License-Identifier: MIT
// Do processes that mpirun starts come to the bytes of one process, and does a run survive the
// death of one of them?
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "problems.h"
#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

Words together(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// What mpirun is told of so many ranks, as root too and on fewer cores. OpenMPI reads that; others
/// need none of it.
Words of_ranks(int ranks, const Words& call) {
  for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                           "OMPI_MCA_rmaps_base_oversubscribe"}) {
    ::setenv(name, "1", 1);
  }
  ::setenv("PRTE_MCA_rmaps_default_mapping_policy", ":oversubscribe", 1);  // OpenMPI 5
  return together({"-n", std::to_string(ranks), MOIVRE_MPI_PROGRAM}, call);
}

std::vector<int> children_of(int process) {
  const std::string name = std::to_string(process);
  std::ifstream file("/proc/" + name + "/task/" + name + "/children");
  std::vector<int> children;
  for (int child = 0; file >> child;) children.push_back(child);
  return children;
}

/// Also where there is no such process.
bool has_ended(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  const std::string stat((std::istreambuf_iterator<char>(file)), {});
  const std::size_t name_end = stat.rfind(") ");
  return name_end == std::string::npos || stat[name_end + 2] == 'Z';
}

/// When a rank was killed OpenMPI's mpirun may wait for itself once all ranks have ended (a lock of
/// PMIx): it is killed then.
void end_hanging(int mpirun) {
  constexpr int kLooks = 1200, kPatience = 50;
  constexpr useconds_t kLook = 100'000;
  for (int look = 0, ended = 0; look < kLooks && ended < kPatience; ++look) {
    if (has_ended(mpirun)) return;
    const std::vector<int> ranks = children_of(mpirun);
    ended = std::all_of(ranks.begin(), ranks.end(), has_ended) ? ended + 1 : 0;
    ::usleep(kLook);
  }
  ::kill(mpirun, SIGKILL);
}

/// `meanwhile` is told the process of mpirun, and kills a rank.
Outcome run_ranks(const Scene& scene, int ranks, const Words& call,
                  const std::function<void(int)>& meanwhile) {
  return scene.run_program(MOIVRE_MPIRUN, of_ranks(ranks, call), [&](int mpirun) {
    meanwhile(mpirun);
    end_hanging(mpirun);
  });
}

/// Ranks that wait for each other are ended after two minutes, with an exit code of 124 or 137.
Outcome run_ranks(const Scene& scene, int ranks, const Words& call) {
  const Words limited{"timeout", "--kill-after=5", "120", MOIVRE_MPIRUN};
  return scene.run_program("/usr/bin/env", together(limited, of_ranks(ranks, call)), [](int) {});
}

std::string timeless(const std::string& text) {
  Json json = Json::parse(text);
  json.erase("time_s");
  return json.dump();
}

void expect_the_same_of_ranks(const Scene& scene, const Words& call,
                              std::initializer_list<int> numbers) {
  const Outcome alone = scene.run(together(call, {"--quiet", "--json", "alone.json"}));
  const std::string base = timeless(scene.read("alone.json"));
  for (const int ranks : numbers) {
    const Outcome outcome =
        run_ranks(scene, ranks, together(call, {"--quiet", "--json", "ranks.json"}));
    EXPECT_EQ(outcome.exit_code, alone.exit_code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(timeless(scene.read("ranks.json")), base) << ranks << " ranks";
  }
}

TEST(Ranks, PathsAndCyclesGiveTheSameBytes) {
  const Scene scene;
  scene.write("f.phc", cyclic(6));
  for (const char* start : {"total-degree", "polyhedral"}) {
    for (const char* tracker : {"lanes", "cvode"}) {
      expect_the_same_of_ranks(
          scene, {"solve", "f.phc", "--start", start, "--tracker", tracker, "--threads", "1"},
          {1, 2, 3});
    }
  }
  // 576 of 720 paths walk circles, in cycles of 3 to 15.
  for (const char* tracker : {"lanes", "cvode"}) {
    expect_the_same_of_ranks(scene,
                             {"solve", MOIVRE_SOURCE_DIR "/problems/polynomials/reimer-5.phc",
                              "--start", "total-degree", "--tracker", tracker},
                             {2, 3});
  }
  scene.write("g.phc", cyclic(7));
  expect_the_same_of_ranks(scene, {"solve", "g.phc", "--tracker", "lanes"}, {2});
  expect_the_same_of_ranks(
      scene, {"solve", MOIVRE_SOURCE_DIR "/problems/polynomials/katsura-10.phc", "--threads", "2"},
      {3});
}

TEST(Ranks, ClosuresAndAMotionGiveTheSameBytes) {
  const Scene scene;
  const std::string folder = MOIVRE_SOURCE_DIR "/problems/mechanisms/";
  expect_the_same_of_ranks(scene, {"closures", folder + "octahedral-3-3.toml"}, {2, 3});
  expect_the_same_of_ranks(scene, {"motion", folder + "four-bar.toml"}, {2});
}

TEST(Ranks, AFamilyAndItsTableGiveTheSameBytes) {
  const Scene scene;
  scene.write("f.phc", "2 5\na*x^2 + b*x*y + y^2 - c; x^2 + y^2 - x - 1;\n");
  std::string table = "a,b,c\n";
  for (int k = 0; k < 300; ++k) {
    table += std::to_string(1 + k % 7) + ",0." + std::to_string(k) + "," + std::to_string(k % 5) +
             ".5\n";
  }
  scene.write("t.csv", table);
  const auto learn = [](const std::string& file) {
    return Words{"family", "learn", "f.phc", "--parameters", "a,b,c", "--monodromy", "-o", file};
  };
  scene.run(learn("alone.family"));
  run_ranks(scene, 2, learn("ranks.family"));
  EXPECT_EQ(scene.read("ranks.family"), scene.read("alone.family"));
  expect_the_same_of_ranks(scene, {"family", "solve", "alone.family", "--table", "t.csv"}, {2, 3});
}

// Families of blocks are learned during some of the samples; borders are lists of their own.
TEST(Ranks, ASweepGivesTheSameBytes) {
  const Scene scene;
  const std::string file = MOIVRE_SOURCE_DIR "/problems/mechanisms/3-rpr.toml";
  expect_the_same_of_ranks(scene,
                           {"sweep", file, "--vary", "leg 1.length=8:24:9", "--vary",
                            "leg 2.length=8:24:9", "--html", "page.html"},
                           {2, 3});
  expect_the_same_of_ranks(scene, {"sweep", file, "--vary", "leg 1.length=8:24:40"}, {2});
  const Words call{"sweep", file, "--vary", "leg 1.length=8:24:40", "--quiet"};
  const Outcome apart =
      run_ranks(scene, 3, together(call, {"--json", "kept.json", "--ledger", "run.db"}));
  EXPECT_EQ(apart.exit_code, 0) << apart.err;
  scene.run(together(call, {"--json", "alone.json"}));
  EXPECT_EQ(timeless(scene.read("kept.json")), timeless(scene.read("alone.json")));
}

/// Of the Kinova arm; every fifth is out of reach, or nearly.
void write_poses(const Scene& scene, int count) {
  std::string poses = "x,y,z,qw,qx,qy,qz\n";
  for (int k = 0; k < count; ++k) {
    const std::string place =
        std::to_string(0.2 + 0.001 * k) + ",0." + std::to_string(k % 5 * 2) + "1,0.4";
    poses += place + (k % 2 == 0 ? ",0.5,-0.5,0.5,0.5\n" : ",0.1,0.7,-0.1,0.7\n");
  }
  scene.write("poses.csv", poses);
}

const Words kKinova{"closures", MOIVRE_SOURCE_DIR "/problems/robots/kinova_j2s6s200.urdf",
                    "--tip",    "j2s6s200_end_effector",
                    "--poses",  "poses.csv"};

TEST(Ranks, PosesOfAnArmGiveTheSameBytes) {
  const Scene scene;
  write_poses(scene, 300);
  for (const char* tracker : {"lanes", "cvode"}) {
    expect_the_same_of_ranks(scene, together(kKinova, {"--tracker", tracker}), {1, 2, 3});
  }
  expect_the_same_of_ranks(
      scene,
      {"closures", MOIVRE_SOURCE_DIR "/problems/robots/panda.urdf", "--tip", "panda_hand", "--pose",
       "0.4 0.1 0.5 0 1 0 0", "--sweep-hold", "panda_joint7=-1:1:7"},
      {2, 3});
}

// Rank 1 tells the results of its own poses, a kilobyte or more each.
TEST(Ranks, ShareThePosesOfAnArm) {
  const Scene scene;
  write_poses(scene, 300);
  ::setenv("MOIVRE_MPI_TRAFFIC", "1", 1);
  const Outcome outcome =
      run_ranks(scene, 2, together(kKinova, {"--quiet", "--json", "r.json", "--threads", "1"}));
  ::unsetenv("MOIVRE_MPI_TRAFFIC");
  const std::string own = outcome.err.substr(outcome.err.find("rank 1 of 2: "));
  const std::size_t bytes = own.find("messages of ") + 12;
  EXPECT_GT(std::stoul(own.substr(bytes)), 20'000) << outcome.err;
}

TEST(Ranks, OnlyTheFirstTells) {
  const Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome alone = scene.run({"solve", "f.phc"});
  const Outcome of_three = run_ranks(scene, 3, {"solve", "f.phc"});
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(lines(of_three.out), lines(alone.out)) << of_three.out;
  const Outcome refused = run_ranks(scene, 2, {"solve", "nothing.phc"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.err.find("nothing.phc: cannot be opened"),
            refused.err.rfind("nothing.phc: cannot be opened"));
  const Outcome told = run_ranks(scene, 2, {"--version"});
  EXPECT_EQ(lines(told.out), 1);
}

/// The processes that mpirun has started, when all are there.
std::vector<int> ranks_of(int mpirun, std::size_t wanted) {
  std::vector<int> ranks;
  for (int look = 0; look < 1000 && ranks.size() < wanted; ++look) {
    ::usleep(10'000);
    ranks = children_of(mpirun);
  }
  return ranks;
}

TEST(Ranks, AfterTheDeathOfOneTheSameCommandGoesOn) {
  const Scene scene;
  scene.write("f.phc", cyclic(6));
  const Words call{"solve", "f.phc", "--start", "total-degree", "--tracker", "cvode"};
  scene.run(together(call, {"--quiet", "--json", "alone.json"}));
  const Words kept = together(call, {"--quiet", "--json", "r.json", "--ledger", "r.db"});
  for (const std::size_t victim : {0U, 1U, 2U}) {
    const auto killed_after = [&](double seconds) {
      for (const char* file : {"r.db", "r.db-wal", "r.db-shm"}) ::unlink(scene.path(file).c_str());
      return run_ranks(scene, 3, kept, [&](int mpirun) {
        const std::vector<int> ranks = ranks_of(mpirun, 3);
        if (victim < ranks.size() && has_worked(ranks[victim], seconds)) {
          ::kill(ranks[victim], SIGKILL);
        }
      });
    };
    // A fast machine has ended before a late kill: then the kill comes twice as early.
    double seconds = 0.3 + 0.1 * static_cast<double>(victim);
    Outcome killed = killed_after(seconds);
    while (killed.exit_code == 0 && seconds > 0.001) killed = killed_after(seconds /= 2);
    EXPECT_NE(killed.exit_code, 0) << "it ends before any kill";
    EXPECT_EQ(run_ranks(scene, 2, kept).exit_code, 0);
    EXPECT_EQ(timeless(scene.read("r.json")), timeless(scene.read("alone.json"))) << victim;
  }
}

TEST(Ranks, PosesGoOnAfterTheDeathOfOne) {
  const Scene scene;
  write_poses(scene, 4000);
  scene.run(together(kKinova, {"--quiet", "--json", "alone.json"}));
  const Words kept = together(kKinova, {"--quiet", "--json", "r.json", "--ledger", "r.db"});
  for (const std::size_t victim : {0U, 1U, 2U}) {
    for (const char* file : {"r.db", "r.db-wal", "r.db-shm"}) ::unlink(scene.path(file).c_str());
    run_ranks(scene, 3, kept, [&](int mpirun) {
      const std::vector<int> ranks = ranks_of(mpirun, 3);
      const double seconds = 0.2 + 0.1 * static_cast<double>(victim);
      if (victim < ranks.size() && has_worked(ranks[victim], seconds)) {
        ::kill(ranks[victim], SIGKILL);
      }
    });
    EXPECT_EQ(run_ranks(scene, 2, kept).exit_code, 0);
    EXPECT_EQ(timeless(scene.read("r.json")), timeless(scene.read("alone.json"))) << victim;
  }
}

TEST(Ranks, EndTogetherWhateverIsOnItsWayBetweenThem) {
  const Scene scene;
  scene.write("f.phc", cyclic(7));
  for (const char* limit : {"0.09", "0.13", "0.17", "0.21", "0.25", "0.29", "0.33", "0.37"}) {
    const Outcome outcome = run_ranks(scene, 2,
                                      {"solve", "f.phc", "--start", "total-degree", "--quiet",
                                       "--tracker", "lanes", "--time-limit", limit});
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 2)
        << limit << " s: exit code " << outcome.exit_code;
  }
}

TEST(Ranks, ALimitOfTimeEndsThemAllAndTheCommandGoesOnAlone) {
  const Scene scene;
  scene.write("f.phc", cyclic(7));
  const Words call{"solve",  "f.phc",     "--start", "total-degree", "--quiet", "--json",
                   "r.json", "--tracker", "lanes",   "--ledger",     "r.db"};
  const Outcome first = run_ranks(scene, 2, together(call, {"--time-limit", "0.1"}));
  EXPECT_EQ(first.exit_code, 2);
  EXPECT_TRUE(contains(first.err, "the time limit of 0.1 s was reached")) << first.err;
  EXPECT_EQ(Json::parse(scene.read("r.json"))["complete"], false);
  EXPECT_EQ(scene.run(call).exit_code, 0);
  const std::string resumed = timeless(scene.read("r.json"));
  scene.run({"solve", "f.phc", "--start", "total-degree", "--quiet", "--json", "r.json",
             "--tracker", "lanes"});
  EXPECT_EQ(resumed, timeless(scene.read("r.json")));
}

}  // namespace
}  // namespace moivre::test
