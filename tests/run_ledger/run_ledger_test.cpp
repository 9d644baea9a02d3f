// SPDX-License-Identifier: MIT
// Does a ledger tell again what it was told, to the last bit, and nothing else, whatever has become
// of its file?
#include "moivre/run_ledger/run_ledger.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "moivre/numeric/bytes.h"
#include "moivre/run_ledger/merge.h"
#include "moivre/run_ledger/standing.h"

namespace moivre {
namespace {

namespace fs = std::filesystem;

const RunIdentity kIdentity{{"command", "solve"}, {"--seed", "1"}};
const Fingerprint kList{1, 2}, kOtherList{3, 4}, kQuestion{5, 6};

class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "moivre-ledger-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name = "run.db") const { return (folder_ / name).string(); }

 private:
  fs::path folder_;
};

std::string outcome_of(std::uint64_t job) {
  ByteWriter bytes;
  bytes.put(job);
  bytes.put(std::vector<double>(job % 50, 1.0 / static_cast<double>(job + 3)));
  return bytes.bytes();
}

void keep(RunLedger& ledger, const Fingerprint& list, std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t job = first; job < last; ++job) {
    ledger.keep(list, JobOutcome{job, outcome_of(job), OutcomeKind::root});
  }
}

void expect_right(const std::map<std::uint64_t, std::string>& outcomes) {
  for (const auto& [job, outcome] : outcomes) EXPECT_EQ(outcome, outcome_of(job)) << job;
}

std::string answer_in(RunLedger& ledger, const std::string& slot) {
  std::string text;
  ledger.read_answer(kQuestion, slot, [&](std::string_view piece) { text += piece; });
  return text;
}

/// An answer of several pieces.
std::string long_text() {
  std::string text;
  for (int k = 0; text.size() < std::size_t{3} << 20; ++k) text += std::to_string(k) + ' ';
  return text;
}

void write_finished(const std::string& file) {
  RunLedger ledger(file, kIdentity);
  keep(ledger, kList, 0, 400);
  ledger.tell(400, 400, 17);
  ledger.close_observations();
  ledger.add_to_answer(kQuestion, "text", "four hundred");
  ledger.add_to_answer(kQuestion, "empty", "");
  ledger.end_answer(kQuestion, 2);
}

std::string content(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string refusal(const std::string& file, const RunIdentity& identity = kIdentity) {
  try {
    RunLedger ledger(file, identity);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::uint64_t committed(const std::string& file) {
  try {
    return read_standing(file).outcomes;
  } catch (const std::invalid_argument&) {
    return 0;  // not laid yet
  }
}

/// Waits for another process to commit. False when it does not within a minute.
bool has_more_outcomes_than(std::uint64_t count, const std::string& file) {
  for (int tries = 0; tries < 12'000; ++tries) {
    if (committed(file) > count) return true;
    ::usleep(5000);
  }
  return false;
}

TEST(RunLedger, TellsWhatItWasToldToTheNextProcess) {
  const Folder folder;
  {
    RunLedger ledger(folder.file(), kIdentity);
    EXPECT_TRUE(ledger.recall(kList).empty());
    keep(ledger, kList, 0, 1000);
    keep(ledger, kOtherList, 5, 7);
  }
  RunLedger ledger(folder.file(), kIdentity);
  EXPECT_EQ(ledger.recall(kList).size(), 1000);
  expect_right(ledger.recall(kList));
  EXPECT_EQ(ledger.recall(kOtherList).size(), 2);
  EXPECT_TRUE(ledger.recall(Fingerprint{9, 9}).empty());
}

TEST(RunLedger, GoesOnAfterAKillWithWhatWasCommitted) {
  const Folder folder;
  std::size_t kept = 0;
  for (int kill = 0; kill < 5; ++kill) {
    const pid_t process = ::fork();
    if (process == 0) {
      RunLedger ledger(folder.file(), kIdentity);
      for (std::uint64_t job = kept;; ++job) {
        keep(ledger, kList, job, job + 1);
        ::usleep(1000);
      }
    }
    EXPECT_TRUE(has_more_outcomes_than(kept, folder.file()));
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
    RunLedger ledger(folder.file(), kIdentity);
    const auto outcomes = ledger.recall(kList);
    EXPECT_GT(outcomes.size(), kept);
    expect_right(outcomes);
    kept = outcomes.size();
  }
}

TEST(RunLedger, KeepsAnAnswerPieceByPiece) {
  const Folder folder;
  const std::string text = long_text();
  {
    RunLedger ledger(folder.file(), kIdentity);
    EXPECT_EQ(ledger.exit_code_of(kQuestion), -1);
    ledger.close_observations();
    for (std::size_t at = 0; at < text.size(); at += 1000) {
      ledger.add_to_answer(kQuestion, "0", std::string_view(text).substr(at, 1000));
      ledger.add_to_answer(kQuestion, "text", "a");
    }
    ledger.add_to_answer(kQuestion, "empty", "");
    ledger.end_answer(kQuestion, 2);
  }
  RunLedger ledger(folder.file(), kIdentity);
  EXPECT_EQ(ledger.exit_code_of(kQuestion), 2);
  EXPECT_EQ(answer_in(ledger, "0"), text);
  EXPECT_EQ(answer_in(ledger, "text").size(), (text.size() + 999) / 1000);
  EXPECT_TRUE(ledger.has_answer(kQuestion, "empty"));
  EXPECT_FALSE(ledger.has_answer(kQuestion, "1"));
  EXPECT_EQ(ledger.exit_code_of(kList), -1);
}

TEST(RunLedger, AnAnswerThatIsNotWholeIsNone) {
  const Folder folder;
  {
    RunLedger ledger(folder.file(), kIdentity);
    ledger.close_observations();
    ledger.add_to_answer(kQuestion, "0", long_text());
  }
  RunLedger ledger(folder.file(), kIdentity);
  EXPECT_EQ(ledger.exit_code_of(kQuestion), -1);
  EXPECT_FALSE(ledger.has_answer(kQuestion, "0"));
}

TEST(RunLedger, AnotherRunsLedgerIsRefusedWithWhatDiffers) {
  const Folder folder;
  write_finished(folder.file());
  const std::string before = content(folder.file());
  EXPECT_EQ(refusal(folder.file(), {{"command", "solve"}, {"--seed", "2"}, {"--slice", "true"}}),
            folder.file() +
                " is the ledger of another run: --seed was 1 and is 2; --slice was nothing and is "
                "true");
  EXPECT_EQ(content(folder.file()), before);
}

TEST(RunLedger, AnotherProcessIsRefusedWhileOneWrites) {
  const Folder folder;
  const RunLedger ledger(folder.file(), kIdentity);
  EXPECT_EQ(refusal(folder.file()), "another process is writing the ledger " + folder.file());
  EXPECT_TRUE(read_standing(folder.file()).is_running);
}

TEST(RunLedger, AFileThatIsNoneStaysAsItIs) {
  const Folder folder;
  for (const std::string& text : {std::string("x + y - 1;\n"), std::string(5000, '\0')}) {
    write(folder.file(), text);
    EXPECT_EQ(refusal(folder.file()), folder.file() + " is no ledger of a run");
    EXPECT_EQ(content(folder.file()), text);
  }
  EXPECT_NE(refusal("/dev/null"), "");
  EXPECT_NE(refusal(folder.file("none/run.db")), "");
}

TEST(RunLedger, AnEmptyFileBecomesOne) {
  const Folder folder;
  write(folder.file(), "");
  EXPECT_EQ(refusal(folder.file()), "");
}

TEST(RunLedger, AnotherFormatIsRefused) {
  const Folder folder;
  write_finished(folder.file());
  std::string bytes = content(folder.file());
  bytes[63] = 7;  // the last byte of user_version in SQLite's header
  write(folder.file(), bytes);
  EXPECT_EQ(refusal(folder.file()),
            folder.file() + " is a ledger of format 7; this version reads and writes 1");
}

/// The ledger is refused, or says nothing that is not right.
void expect_nothing_false(const std::string& file) {
  try {
    RunLedger ledger(file, kIdentity);
    expect_right(ledger.recall(kList));
    const int code = ledger.exit_code_of(kQuestion);
    EXPECT_TRUE(code == 2 || code == -1) << code;
    if (code == -1) return;
    for (const std::string slot : {"text", "empty"}) {
      if (!ledger.has_answer(kQuestion, slot)) continue;
      EXPECT_EQ(answer_in(ledger, slot), slot == "text" ? "four hundred" : "");
    }
  } catch (const std::invalid_argument&) {
    // A clear end.
  }
}

TEST(RunLedger, BitsThatHaveFlippedMakeNothingFalse) {
  const Folder folder;
  write_finished(folder.file());
  const std::string whole = content(folder.file());
  ASSERT_GT(whole.size(), 20'000);
  for (std::size_t at = 0; at < whole.size(); at += 211) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
    write(folder.file("flipped.db"), damaged);
    expect_nothing_false(folder.file("flipped.db"));
    for (const char* tail : {"-wal", "-shm"}) fs::remove(folder.file("flipped.db") + tail);
  }
}

TEST(RunLedger, ATruncatedFileIsRefusedOrRight) {
  const Folder folder;
  write_finished(folder.file());
  const std::string whole = content(folder.file());
  for (std::size_t size = 1; size < whole.size(); size += 1009) {
    write(folder.file("cut.db"), whole.substr(0, size));
    expect_nothing_false(folder.file("cut.db"));
    for (const char* tail : {"-wal", "-shm"}) fs::remove(folder.file("cut.db") + tail);
  }
}

std::string refusal_to_merge(const std::string& file, const std::vector<std::string>& parts) {
  try {
    merge_ledgers(file, parts);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

void write_part(const std::string& file, std::uint64_t first, std::uint64_t last,
                const RunIdentity& identity = kIdentity) {
  RunLedger ledger(file, identity);
  keep(ledger, kList, first, last);
}

TEST(RunLedger, PartsHoldTogetherWhatEachOfThemHolds) {
  const Folder folder;
  const std::string a = folder.file("a.db"), b = folder.file("b.db"), whole = folder.file("w.db");
  write_part(a, 0, 300);
  write_part(b, 300, 500);
  merge_ledgers(whole, {a, b});
  merge_ledgers(whole, {b, a});  // once more is once
  EXPECT_EQ(read_standing(whole).outcomes, 500);
  RunLedger ledger(whole, kIdentity);
  EXPECT_EQ(ledger.recall(kList).size(), 500);
  expect_right(ledger.recall(kList));
}

TEST(RunLedger, PartsOfAnotherRunAreRefusedAndNothingIsMade) {
  const Folder folder;
  const std::string a = folder.file("a.db"), b = folder.file("b.db"), whole = folder.file("w.db");
  write_part(a, 0, 3);
  write_part(b, 0, 3, {{"command", "solve"}, {"--seed", "2"}});
  EXPECT_EQ(refusal_to_merge(whole, {a, b}),
            b + " is the ledger of another run: --seed was 2 and is 1");
  EXPECT_FALSE(fs::exists(whole));
  EXPECT_EQ(refusal_to_merge(a, {b}), a + " is the ledger of another run: --seed was 1 and is 2");
  EXPECT_EQ(refusal_to_merge(a, {a}), a + " is the ledger that the parts are to go into");
  const RunLedger writer(a, kIdentity);
  EXPECT_EQ(refusal_to_merge(whole, {a}), a + " is being written by a run");
}

TEST(RunLedger, APartThatIsDamagedIsRefused) {
  const Folder folder;
  const std::string a = folder.file("a.db"), whole = folder.file("w.db");
  write_part(a, 0, 300);
  std::string bytes = content(a);
  const std::size_t at = bytes.find(outcome_of(40));
  ASSERT_NE(at, std::string::npos);
  bytes[at + sizeof(std::uint64_t)] ^= 1;
  write(a, bytes);
  EXPECT_NE(refusal_to_merge(whole, {a}).find("a.db is damaged"), std::string::npos);
}

/// In a process that may write no file beyond so many bytes, which is room enough for what it
/// commits at first; its exit code says how it went.
int outcome_with_room(const std::string& file, rlim_t bytes) {
  constexpr std::uint64_t kFirst = 500;
  int go_on[2] = {};
  EXPECT_EQ(::pipe(go_on), 0);
  const pid_t process = ::fork();
  if (process == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit limit { bytes, bytes };
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::atomic<bool> has_stopped{false};
    RunLedger ledger(file, kIdentity, [&] { has_stopped = true; });
    keep(ledger, kList, 0, kFirst);
    char word = 0;
    if (::read(go_on[0], &word, 1) != 1) ::_exit(9);
    for (std::uint64_t job = kFirst; job < 20'000 && !has_stopped; ++job) {
      keep(ledger, kList, job, job + 1);
    }
    ledger.close_observations();
    const bool is_told =
        ledger.failure().find("what was committed before stands") != std::string::npos;
    ::_exit(has_stopped && is_told ? 7 : 8);
  }
  EXPECT_TRUE(has_more_outcomes_than(kFirst - 1, file));
  EXPECT_EQ(::write(go_on[1], "", 1), 1);
  for (const int end : go_on) ::close(end);
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(RunLedger, WhereThereIsNoMoreRoomItSaysSoAndLosesNothing) {
  const Folder folder;
  EXPECT_EQ(outcome_with_room(folder.file(), rlim_t{400'000}), 7);
  RunLedger ledger(folder.file(), kIdentity);
  const auto outcomes = ledger.recall(kList);
  EXPECT_GE(outcomes.size(), 500);
  expect_right(outcomes);
}

TEST(RunLedger, AFileThatIsTakenAwayIsNoticed) {
  const Folder folder;
  RunLedger ledger(folder.file(), kIdentity);
  fs::remove(folder.file());
  keep(ledger, kList, 0, 1);
  ledger.close_observations();
  EXPECT_NE(ledger.failure().find("no longer in its place"), std::string::npos);
}

TEST(RunLedger, ItsStandingIsReadBesideIt) {
  const Folder folder;
  write_finished(folder.file());
  const RunStanding standing = read_standing(folder.file());
  EXPECT_EQ(standing.identity, kIdentity);
  EXPECT_FALSE(standing.is_running);
  EXPECT_TRUE(standing.is_finished);
  EXPECT_EQ(standing.exit_code, 2);
  EXPECT_EQ(standing.done, 400);
  EXPECT_EQ(standing.roots, 17);
  EXPECT_EQ(standing.to_roots, 400);
  std::string text;
  EXPECT_TRUE(
      read_last_answer(folder.file(), "text", [&](std::string_view piece) { text += piece; }));
  EXPECT_EQ(text, "four hundred");
  EXPECT_THROW(read_standing(folder.file("none.db")), std::invalid_argument);
}

}  // namespace
}  // namespace moivre
