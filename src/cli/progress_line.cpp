// SPDX-License-Identifier: MIT
// The progress line: carriage return, text, erase to the end of the line.
#include "progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace moivre {
namespace {

// A run that ends before needs no line.
constexpr std::chrono::seconds kPatience{1};
// Often enough to look alive, seldom enough to cost nothing.
constexpr std::chrono::milliseconds kPeriod{100};

}  // namespace

ProgressLine::ProgressLine(bool wanted)
    : active_(wanted && ::isatty(STDERR_FILENO) != 0), next_(begin_ + kPatience) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::show(const Progress& progress) {
  if (!active_ || Clock::now() < next_) return;
  if (progress.search) {
    const int percent = static_cast<int>(100 * *progress.search);
    return show(std::to_string(progress.cells) + " mixed cells, search about " +
                    std::to_string(percent) + " % done",
                *progress.search);
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  char rate[32];
  std::snprintf(rate, sizeof rate, "%.3g", static_cast<double>(progress.done) / seconds);
  show(std::to_string(progress.done) + " of " + std::to_string(progress.total) + " paths, " +
           std::to_string(progress.finite) + " finite, " + rate + " a second",
       static_cast<double>(progress.done) /
           static_cast<double>(std::max<std::uint64_t>(1, progress.total)));
}

void ProgressLine::show(const std::string& text, double done) {
  const Clock::time_point now = Clock::now();
  if (!active_ || now < next_) return;
  next_ = now + kPeriod;
  shown_ = true;
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  std::string left;
  if (done > 0 && done < 1) {
    char number[48];
    std::snprintf(number, sizeof number, ", about %.0f s left", seconds * (1 - done) / done);
    left = number;
  }
  std::fprintf(stderr, "\r%s, %.0f s%s\x1b[K", text.c_str(), seconds, left.c_str());
  std::fflush(stderr);
}

}  // namespace moivre
