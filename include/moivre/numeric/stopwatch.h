// SPDX-License-Identifier: MIT
// How many wall seconds did that take? A clock that runs from where it was made.
//
// Steady: it does not follow changes of the machine's date. Not supported: CPU time.
#pragma once

#include <chrono>

namespace moivre {

class Stopwatch {
 public:
  /// Seconds since it was made.
  double total() const { return seconds_since(begin_); }

  /// Seconds since the last lap; the first lap begins where it was made.
  double lap() {
    const double seconds = seconds_since(lap_);
    lap_ = Clock::now();
    return seconds;
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }

  Clock::time_point begin_ = Clock::now();
  Clock::time_point lap_ = begin_;
};

}  // namespace moivre
