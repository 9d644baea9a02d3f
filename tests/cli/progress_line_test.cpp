// SPDX-License-Identifier: MIT
// Does the progress line show that a run goes on while nothing new is told of it?
#include "progress_line.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <string>

namespace moivre::test {
namespace {

/// stderr is a terminal of ours while it lives.
class Terminal {
 public:
  Terminal() : stderr_(::dup(STDERR_FILENO)) {
    int terminal = -1;
    if (::openpty(&ours_, &terminal, nullptr, nullptr, nullptr) != 0) return;
    ::dup2(terminal, STDERR_FILENO);
    ::close(terminal);
  }
  ~Terminal() {
    ::dup2(stderr_, STDERR_FILENO);
    ::close(stderr_);
    ::close(ours_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  bool is_open() const { return ours_ >= 0; }
  /// What was written to it by now; waits for the first of it at most so long.
  std::string read(int milliseconds) {
    std::string text;
    pollfd wait{ours_, POLLIN, 0};
    while (::poll(&wait, 1, text.empty() ? milliseconds : 0) > 0) {
      char piece[256];
      const ssize_t count = ::read(ours_, piece, sizeof piece);
      if (count <= 0) break;
      text.append(piece, static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int stderr_;
  int ours_ = -1;
};

constexpr int kLongest = 20'000;  // a busy machine's

TEST(ProgressLine, ItsSecondsGoOnWhereNothingIsTold) {
  Terminal terminal;
  if (!terminal.is_open()) GTEST_SKIP() << "no terminal can be had";
  std::string seen;
  {
    ProgressLine line(true);
    Progress progress;
    progress.done = progress.total = 8;
    progress.finite = 5;
    while (seen.empty()) {
      line.show(progress);
      seen = terminal.read(50);
    }
    EXPECT_NE(seen.find("8 of 8 paths, 5 finite, settling what is open, "), std::string::npos);
    EXPECT_EQ(seen.find("left"), std::string::npos) << seen;
    const std::string next = terminal.read(kLongest);
    EXPECT_NE(next.find("settling what is open, "), std::string::npos) << next;
    EXPECT_NE(next, seen);
  }
  EXPECT_TRUE(terminal.read(kLongest).ends_with("\r\x1b[K"));
}

TEST(ProgressLine, TellsNoTimeLeftWhereTheTimeItForetoldIsOver) {
  Terminal terminal;
  if (!terminal.is_open()) GTEST_SKIP() << "no terminal can be had";
  ProgressLine line(true);
  Progress progress;
  progress.done = 999'999;
  progress.total = 1'000'000;
  std::string seen;
  while (seen.empty()) {
    line.show(progress);
    seen = terminal.read(50);
  }
  EXPECT_NE(seen.find("about 0 s left"), std::string::npos) << seen;
  const std::string next = terminal.read(kLongest);
  EXPECT_NE(next.find("999999 of 1000000 paths"), std::string::npos) << next;
  EXPECT_EQ(next.find("left"), std::string::npos) << next;
}

TEST(ProgressLine, IsErasedForGoodBeforeResultsAreTold) {
  Terminal terminal;
  if (!terminal.is_open()) GTEST_SKIP() << "no terminal can be had";
  ProgressLine line(true);
  std::string seen;
  while (seen.empty()) {
    line.show("7 loops", 0.5);
    seen = terminal.read(50);
  }
  line.end();
  EXPECT_TRUE(terminal.read(kLongest).ends_with("\r\x1b[K"));
  line.show("8 loops", 0.75);
  EXPECT_EQ(terminal.read(1500), "");
}

}  // namespace
}  // namespace moivre::test
