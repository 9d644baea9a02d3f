// SPDX-License-Identifier: MIT
// Does the program end whole where the machine gives no more: time, memory, room on the disk, a
// terminal?
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "moivre/expression/source.h"
#include "problems.h"
#include "program.h"

namespace moivre::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kInterrupted = "interrupted: what is finished is reported";

/// x1 = 1 and x_{k+1} = 2 x_k - x_{k-1} + ..., each with some more unknowns: linear, and long to
/// eliminate.
std::string linear_equations(int n) {
  std::string text = std::to_string(n) + "\n";
  for (int i = 1; i <= n; ++i) {
    text += "x" + std::to_string(i);
    for (int k = 1; k <= 6; ++k) {
      const int j = (i * (2 * k + 1) + 7 * k * k) % n + 1;
      text += " + " + std::to_string(i % 9 + k) + "*x" + std::to_string(j);
    }
    text += " - 1;\n";
  }
  return text;
}

TEST(Faults, ALostTerminalEndsARunWithWhatIsFinished) {
  const Scene scene;
  scene.write("f.phc", katsura(13));
  const Outcome outcome = scene.run_until({"solve", "f.phc", "--threads", "2", "--json", "f.json"},
                                          " of 8192 paths, ", SIGHUP);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(Json::parse(scene.read("f.json"))["message"], kInterrupted);
}

TEST(Faults, ALimitOfTimeEndsARunWithWhatIsFinished) {
  const Scene scene;
  scene.write("f.phc", katsura(13));
  const Outcome outcome = scene.run({"solve", "f.phc", "--time-limit", "0.5", "--json", "f.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "moivre: the time limit of 0.5 s was reached\n");
  const Json json = Json::parse(scene.read("f.json"));
  EXPECT_EQ(json["complete"], false);
  // On a busy machine no path may have been begun.
  EXPECT_TRUE(json["message"].get<std::string>().starts_with("interrupted: ")) << json["message"];
  for (const char* none : {"0", "-1", "abc", "nan"}) {
    const Outcome refused = scene.run({"solve", "f.phc", "--time-limit", none});
    EXPECT_EQ(refused.exit_code, 1) << none;
    EXPECT_EQ(refused.err,
              std::string("moivre: --time-limit: a number of seconds above 0 is needed, not '") +
                  none + "'\nmoivre --help shows how to call it.\n");
  }
}

TEST(Faults, ALimitOfTimeMayBeShorterThanTheSystemsTimerCounts) {
  const Scene scene;
  scene.write("f.phc", katsura(13));
  EXPECT_EQ(scene.run({"solve", "f.phc", "--quiet", "--time-limit", "1e-9"}).exit_code, 2);
  scene.write("g.phc", kCircleAndHyperbola);
  EXPECT_EQ(scene.run({"solve", "g.phc", "--quiet", "--time-limit", "1e300"}).exit_code, 0);
}

TEST(Faults, ALimitOfTimeThatIsNotReachedChangesNothing) {
  const Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Outcome outcome = scene.run({"solve", "f.phc", "--time-limit", "1000"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST(Faults, EliminationEndsWhereItIsInterrupted) {
  const Scene scene;
  scene.write("f.phc", linear_equations(3000));
  const auto begin = std::chrono::steady_clock::now();
  for (const char* command : {"solve", "info"}) {
    const Outcome outcome = scene.run({command, "f.phc", "--quiet", "--json", "f.json"}, false,
                                      send_after(0.3, SIGTERM));
    EXPECT_EQ(outcome.exit_code, 2) << command << outcome.err;
    EXPECT_TRUE(scene.has("f.json"));
  }
  // It would take more than a minute.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

TEST(Faults, ASweepEndsWhereItIsInterrupted) {
  const Scene scene;
  const std::string rpr = std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/3-rpr.toml";
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome = scene.run({"sweep", rpr, "--vary", "leg 1.length=8:24:100", "--vary",
                                     "leg 2.length=8:24:100", "--quiet", "--json", "s.json"},
                                    false, send_after(0.3, SIGTERM));
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  const Json json = Json::parse(scene.read("s.json"));
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["samples"].back()["complete"], false);
  // It would take a minute of processor time.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

TEST(Faults, AFamilyThatIsHalfLearnedIsKept) {
  const Scene scene;
  const std::string nine = std::string(MOIVRE_SOURCE_DIR) + "/problems/families/nine-point.bertini";
  const Outcome outcome = scene.run({"family", "learn", nine, "--monodromy", "--tracker", "lanes",
                                     "--time-limit", "3", "-o", "nine.family"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  const Outcome info = scene.run({"family", "info", "nine.family", "--json", "-"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  const Json family = Json::parse(info.out)["families"][0];
  EXPECT_GT(family["roots"], 0);
  EXPECT_EQ(family["learning"]["complete"], false);
  EXPECT_TRUE(contains(family["learning"]["standing"], "interrupted after ")) << family;
}

/// A seven-link structure, and beside it a 3-RPR platform: a family each.
std::string two_structures() {
  const std::filesystem::path folder =
      std::filesystem::path(MOIVRE_SOURCE_DIR) / "problems" / "mechanisms";
  std::string links = read_source((folder / "assur-7-quaternary.toml").string()).text;
  const std::string platform = read_source((folder / "3-rpr.toml").string()).text;
  const std::string ground = "[ground.points]\n";
  const std::size_t points = platform.find(ground) + ground.size();
  const std::size_t body = platform.find("[body.");
  const std::size_t guess = platform.find("[guess]\n");
  links.insert(links.find(ground) + ground.size(), platform.substr(points, body - points));
  links.insert(links.find("[guess]\n"), platform.substr(body, guess - body));
  return links + platform.substr(guess + std::string("[guess]\n").size());
}

// Whenever it is interrupted.
TEST(Faults, FamiliesOfAMechanismThatAreWholeAreKept) {
  const Scene scene;
  scene.write("two.toml", two_structures());
  for (double seconds = 0.05; seconds < 0.4; seconds += 0.05) {
    std::filesystem::remove(scene.path("two.family"));
    const Outcome outcome = scene.run(
        {"family", "learn", "two.toml", "--rtol", "1e-10", "--threads", "1", "-o", "two.family"},
        false, [seconds](int process) {
          if (catches_interrupt(process) && has_worked(process, seconds)) ::kill(process, SIGTERM);
        });
    if (outcome.exit_code == 1) {
      EXPECT_EQ(outcome.err, "moivre: interrupted: nothing was learned\n");
      EXPECT_FALSE(scene.has("two.family"));
      continue;
    }
    const Outcome info = scene.run({"family", "info", "two.family", "--json", "-"});
    ASSERT_EQ(info.exit_code, 0) << info.err;
    const Json families = Json::parse(info.out)["families"];
    EXPECT_GE(families.size(), 1u);
    EXPECT_TRUE(outcome.exit_code == 2 || families.size() == 2) << info.out;
    for (const Json& family : families) EXPECT_EQ(family["learning"]["complete"], true) << family;
  }
}

TEST(Faults, AFamilyWhosePlaceHasNoRoomIsKeptElsewhere) {
  const Scene scene;
  scene.write("f.phc", "2 3\nx^2 + a*x*y + y^2 - 1; x^2 - y - 2;\n");
  const Outcome outcome =
      scene.run({"family", "learn", "f.phc", "--parameters", "a", "-o", "/dev/full"});
  EXPECT_EQ(outcome.exit_code, 1);
  const std::string said =
      "moivre: cannot write /dev/full: No space left on device; what was learned is in ";
  ASSERT_TRUE(outcome.err.starts_with(said)) << outcome.err;
  const std::string elsewhere =
      outcome.err.substr(said.size(), outcome.err.find('\n') - said.size());
  const Outcome info = scene.run({"family", "info", elsewhere, "--json", "-"});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_EQ(Json::parse(info.out)["families"][0]["roots"], 4);
  std::filesystem::remove(elsewhere);
}

TEST(Faults, TwoRunsOnOneFamilyFileLoseNothing) {
  const Scene scene;
  const std::string folder = std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/";
  const auto closures = [&](const std::string& mechanism) {
    return std::vector<std::string>{"closures", folder + mechanism, "--family", "both.family",
                                    "--quiet"};
  };
  const auto families = [&] {
    const Outcome info = scene.run({"family", "info", "both.family", "--json", "-"});
    return Json::parse(info.out)["families"].size();
  };
  scene.run(closures("assur-7-quaternary.toml"));
  const std::size_t one = families();
  std::filesystem::remove(scene.path("both.family"));
  scene.run(closures("3-rpr.toml"));
  const std::size_t other = families();
  std::filesystem::remove(scene.path("both.family"));
  ASSERT_GT(one + other, 1U);
  scene.run(closures("assur-7-quaternary.toml"), false,
            [&](int) { scene.run(closures("3-rpr.toml")); });
  EXPECT_EQ(families(), one + other);
}

/// What happens in the scene's folder to the file of this name, from when it is made.
class Watch {
 public:
  Watch(const Scene& scene, std::string name) : name_(std::move(name)) {
    inotify_add_watch(queue_, scene.path(".").c_str(), IN_CREATE | IN_DELETE | IN_MOVED_TO);
  }
  ~Watch() { close(queue_); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  std::vector<std::uint32_t> events() const {
    alignas(inotify_event) std::array<char, 1 << 16> buffer{};
    const ssize_t size = read(queue_, buffer.data(), buffer.size());
    std::vector<std::uint32_t> masks;
    for (ssize_t at = 0; at < size;) {
      const auto* event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
      if (event->len > 0 && name_ == event->name) masks.push_back(event->mask);
      at += static_cast<ssize_t>(sizeof(inotify_event)) + event->len;
    }
    return masks;
  }

 private:
  int queue_ = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  std::string name_;
};

// Another run may move its file to the same place meanwhile; an empty one there, or one removed,
// would lose it.
TEST(Faults, APlaceForAFileIsTriedWithoutTouchingIt) {
  const Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  const Watch watch(scene, "f.json");
  EXPECT_EQ(scene.run({"solve", "f.phc", "--json", "f.json"}).exit_code, 0);
  EXPECT_EQ(watch.events(), std::vector<std::uint32_t>{IN_MOVED_TO});
}

/// Waits until the process has a file in the scene's folder open that has grown beyond a megabyte.
/// False when it ended before.
bool has_begun_to_write(const Scene& scene, int process) {
  constexpr std::uintmax_t kBegun = 1 << 20;
  const std::string here = std::filesystem::canonical(scene.path(".")).string();
  std::error_code ignored;
  while (has_worked(process, 0)) {
    const std::string folder = "/proc/" + std::to_string(process) + "/fd";
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      // Others were open before, as the log of the tests.
      const std::string file = std::filesystem::read_symlink(entry, ignored).string();
      if (!file.starts_with(here)) continue;
      const std::uintmax_t size = entry.file_size(ignored);
      if (!ignored && size > kBegun) return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

TEST(Faults, ARunThatIsKilledWhileItWritesLeavesNoDraft) {
  const Scene scene;
  const std::string four_bar =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
  const Outcome outcome =
      scene.run({"motion", four_bar, "--steps", "50000", "--quiet", "--json", "m.json"}, false,
                [&scene](int process) {
                  EXPECT_TRUE(catches_interrupt(process));
                  EXPECT_TRUE(has_begun_to_write(scene, process)) << "it ended before";
                  ::kill(process, SIGKILL);
                });
  EXPECT_EQ(outcome.exit_code, -1);
  EXPECT_FALSE(scene.has("m.json"));
  EXPECT_FALSE(contains(scene.listing(), ".moivre-")) << scene.listing();
}

// A signal ends the writing within a second: results that take no longer are whole, others are not
// there.
TEST(Faults, ASignalWhileResultsAreWrittenLeavesThemWholeOrNotThere) {
  const Scene scene;
  const std::string four_bar =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
  const Outcome outcome =
      scene.run({"motion", four_bar, "--steps", "20000", "--quiet", "--json", "m.json"}, false,
                [&scene](int process) {
                  EXPECT_TRUE(catches_interrupt(process));
                  EXPECT_TRUE(has_begun_to_write(scene, process)) << "it ended before";
                  ::kill(process, SIGTERM);
                });
  if (outcome.exit_code == 1) {
    EXPECT_TRUE(outcome.err.starts_with("moivre: interrupted: m.json was not written\n"))
        << outcome.err;
    EXPECT_FALSE(scene.has("m.json"));
  } else {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(Json::parse(scene.read("m.json"))["complete"], true);
  }
}

TEST(Faults, AReaderThatStandsStillDoesNotHoldARunThatIsInterrupted) {
  const Scene scene;
  const std::string four_bar =
      std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/four-bar.toml";
  const std::string pipe = scene.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  const Outcome outcome =
      scene.run({"motion", four_bar, "--steps", "2000", "--quiet", "--json", "pipe"}, false,
                [reader](int process) {
                  std::array<char, 1 << 16> piece{};
                  ssize_t length = -1;
                  while (has_worked(process, 0) && length <= 0) {
                    length = ::read(reader, piece.data(), piece.size());
                  }
                  ::kill(process, SIGTERM);
                  std::this_thread::sleep_for(std::chrono::seconds(1));
                  while (has_worked(process, 0))
                    length = ::read(reader, piece.data(), piece.size());
                });
  ::close(reader);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "moivre: interrupted: pipe was not written\n")) << outcome.err;
}

// Behind the last path, where what is open is settled by many more solves.
TEST(Faults, SettlingEndsWhereItIsInterrupted) {
  const Scene scene;
  const std::string hc574 = std::string(MOIVRE_SOURCE_DIR) + "/problems/people/undecided-hc574.phc";
  const Outcome outcome =
      scene.run_until({"solve", hc574, "--tracker", "lanes", "--threads", "1", "--json", "f.json"},
                      "settling what is open", SIGTERM);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  const Json json = Json::parse(scene.read("f.json"));
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["message"], kInterrupted);
  EXPECT_LT(outcome.after_signal, 10);  // seconds, of a machine that may be busy
}

/// The program gets no more address space than this.
std::function<void(int)> limit_memory(rlim_t bytes) {
  return [bytes](int process) {
    const rlimit limit{bytes, bytes};
    ::prlimit(process, RLIMIT_AS, &limit, nullptr);
  };
}

TEST(Faults, PathsThatCannotBeKeptAreRefusedBeforeTheyAreFollowed) {
  const Scene scene;
  scene.write("f.phc", "1\nx^4294967295 - 1;\n");
  const Outcome outcome = scene.run({"solve", "f.phc"}, false, limit_memory(rlim_t{2} << 30));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "moivre: 4294967295 paths take 68.7 GB at least, and there "))
      << outcome.err;
}

// More paths than 64 bits count are no reason to look for fewer at any price.
TEST(Faults, QuadricsOfManyUnknownsAreRefusedInLittleMemory) {
  const Scene scene;
  std::string text = "500\n";
  for (int i = 0; i < 500; ++i) text += "x" + std::to_string(i) + "^2 - 1;\n";
  scene.write("f.phc", text);
  const Outcome outcome = scene.run({"solve", "f.phc"}, false, limit_memory(rlim_t{512} << 20));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "the Bezout number does not fit into 64 bits")) << outcome.err;
}

// Wherever memory runs out the program ends by itself: with what is finished, or with a sentence.
TEST(Faults, NoLimitOfMemoryEndsARunWithoutAWord) {
  const Scene scene;
  scene.write("f.phc", katsura(11));
  int told = 0;
  for (rlim_t megabytes = 60; megabytes <= 400; megabytes += 20) {
    std::filesystem::remove(scene.path("f.json"));
    const Outcome outcome =
        scene.run({"solve", "f.phc", "--tracker", "lanes", "--threads", "2", "--json", "f.json"},
                  false, limit_memory(megabytes << 20));
    EXPECT_NE(outcome.exit_code, -1) << megabytes << outcome.err;
    if (outcome.exit_code == 1) {
      EXPECT_FALSE(outcome.err.empty()) << megabytes;
      continue;
    }
    ++told;
    EXPECT_TRUE(Json::accept(scene.read("f.json"))) << megabytes;
  }
  EXPECT_GT(told, 0);
}

TEST(Faults, NoLimitOfMemoryEndsACheckWithoutAWord) {
  const Scene scene;
  scene.write("f.phc", katsura(11));
  ASSERT_EQ(
      scene.run({"solve", "f.phc", "--tracker", "lanes", "--quiet", "--json", "f.json"}).exit_code,
      0);
  int judged = 0;
  for (rlim_t megabytes = 60; megabytes <= 300; megabytes += 20) {
    const Outcome outcome =
        scene.run({"check", "f.phc", "f.json"}, false, limit_memory(megabytes << 20));
    EXPECT_NE(outcome.exit_code, -1) << megabytes << outcome.err;
    if (outcome.exit_code == 0) {
      ++judged;
    } else {
      EXPECT_FALSE(outcome.err.empty()) << megabytes;
    }
  }
  EXPECT_GT(judged, 0);
}

TEST(Faults, AResultOfMoreThan256MegabytesIsChecked) {
  const Scene scene;
  scene.write("f.phc", kCircleAndHyperbola);
  ASSERT_EQ(scene.run({"solve", "f.phc", "--quiet", "--json", "f.json"}).exit_code, 0);
  std::string json = scene.read("f.json");
  const std::size_t end = json.rfind('}');
  ASSERT_NE(end, std::string::npos);
  json.insert(end, std::string(std::size_t{257} << 20, ' '));
  scene.write("f.json", json);
  const Outcome outcome = scene.run({"check", "f.phc", "f.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

/// What the process has had in memory at most, in bytes, as long as it can be asked.
std::size_t peak_of(int process) {
  std::size_t kilobytes = 0;
  while (has_worked(process, 0)) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string word; status >> word;) {
      if (word == "VmHWM:") status >> kilobytes;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return kilobytes << 10;
}

// docs/long-runs.md: about 0.31 kB + 20 n bytes of each root, 16 bytes of each path.
TEST(Faults, ARootTakesAsMuchMemoryAsIsPromised) {
  const Scene scene;
  const auto squares = [](int n) {
    std::string text = std::to_string(n) + "\n";
    for (int k = 1; k <= n; ++k) text += "x" + std::to_string(k) + "^2 - 1;\n";
    return text;
  };
  scene.write("few.phc", squares(10));
  scene.write("many.phc", squares(15));
  std::map<std::string, std::size_t> peak;
  for (const std::string system : {"few", "many"}) {
    const Outcome outcome = scene.run({"solve", system + ".phc", "--tracker", "lanes", "--threads",
                                       "1", "--quiet", "--json", "f.json", "--csv", "f.csv"},
                                      false, [&](int process) { peak[system] = peak_of(process); });
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  const double roots = (1 << 15) - (1 << 10);
  const double a_root = static_cast<double>(peak["many"] - peak["few"]) / roots;
  constexpr double kPromised = 310 + 20 * 15 + 16;
  EXPECT_LT(a_root, 1.25 * kPromised);  // the smaller system's pages are a part of it
}

}  // namespace
}  // namespace moivre::test
