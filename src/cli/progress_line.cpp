// SPDX-License-Identifier: MIT
// The progress line: carriage return, text, erase to the end of the line; by those who have news,
// and by a thread each second.
#include "progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <system_error>

namespace moivre {
namespace {

// A run that ends before needs no line.
constexpr std::chrono::seconds kPatience{1};
// Often enough to look alive, seldom enough to cost nothing.
constexpr std::chrono::milliseconds kPeriod{100};
constexpr std::chrono::seconds kTick{1};

/// Long work, maybe, without another report.
bool is_settling(const Progress& progress) {
  return !progress.search && progress.done >= progress.total;
}

std::string text_of(const Progress& progress, double seconds) {
  if (progress.search) {
    const int percent = static_cast<int>(100 * *progress.search);
    return std::to_string(progress.cells) + " mixed cells, search about " +
           std::to_string(percent) + " % done";
  }
  const std::string text = std::to_string(progress.done) + " of " + std::to_string(progress.total) +
                           " paths, " + std::to_string(progress.finite) + " finite, ";
  if (is_settling(progress)) return text + "settling what is open";
  char rate[32];
  std::snprintf(rate, sizeof rate, "%.3g", static_cast<double>(progress.done) / seconds);
  return text + rate + " a second";
}

/// 0: nobody knows.
double done_of(const Progress& progress) {
  if (is_settling(progress)) return 0;
  if (progress.search) return *progress.search;
  return static_cast<double>(progress.done) /
         static_cast<double>(std::max<std::uint64_t>(1, progress.total));
}

}  // namespace

ProgressLine::ProgressLine(bool wanted)
    : active_(wanted && ::isatty(STDERR_FILENO) != 0), next_(begin_ + kPatience) {
  if (!active_) return;
  try {
    seconds_ = std::thread([this] { go_on_by_itself(); });
  } catch (const std::system_error&) {
    // The line stands still between two reports.
  }
}

ProgressLine::~ProgressLine() { end(); }

void ProgressLine::end() {
  {
    const std::lock_guard lock(mutex_);
    active_ = false;
    is_over_ = true;
  }
  wake_.notify_one();
  if (seconds_.joinable()) seconds_.join();
  if (shown_) std::fputs("\r\x1b[K", stderr);
  shown_ = false;
}

void ProgressLine::show(const Progress& progress) {
  if (!active_ || !(is_settling(progress) || is_due())) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  show(text_of(progress, seconds), done_of(progress));
}

void ProgressLine::show(const std::string& text, double done) {
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (!active_) return;
  text_ = text;
  if (done_ != done) done_since_ = now;
  done_ = done;
  if (now >= next_) draw(now);
}

bool ProgressLine::is_due() {
  const std::lock_guard lock(mutex_);
  return Clock::now() >= next_;
}

void ProgressLine::draw(Clock::time_point now) {
  next_ = now + kPeriod;
  shown_ = true;
  const auto seconds_to = [this](Clock::time_point end) {
    return std::chrono::duration<double>(end - begin_).count();
  };
  const double seconds = seconds_to(now);
  std::string left;
  if (done_ > 0 && done_ < 1) {
    const double foretold = seconds_to(done_since_) / done_;
    char number[48];
    std::snprintf(number, sizeof number, ", about %.0f s left", foretold - seconds);
    if (foretold > seconds) left = number;
  }
  std::fprintf(stderr, "\r%s, %.0f s%s\x1b[K", text_.c_str(), seconds, left.c_str());
  std::fflush(stderr);
}

void ProgressLine::go_on_by_itself() {
  std::unique_lock lock(mutex_);
  while (!is_over_) {
    wake_.wait_for(lock, kTick, [this] { return is_over_; });
    if (!is_over_ && shown_) draw(Clock::now());
  }
}

}  // namespace moivre
