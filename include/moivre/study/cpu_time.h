// SPDX-License-Identifier: MIT
// How long does something take, in CPU seconds of this process? Short runs are repeated until the
// clock can tell.
#pragma once

#include <ctime>
#include <functional>
#include <vector>

namespace moivre {

/// Runs shorter than this in all are repeated, so that the clock's ticks and the cache's first
/// misses do not show.
inline constexpr double kLeastTimed_s = 0.05;
inline constexpr int kMostRepetitions = 5;

inline double cpu_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// CPU seconds of each repetition of `run`, one at least.
inline std::vector<double> time_runs(const std::function<void()>& run) {
  std::vector<double> seconds;
  double total = 0;
  while (seconds.empty() ||
         (total < kLeastTimed_s && static_cast<int>(seconds.size()) < kMostRepetitions)) {
    const double begin = cpu_seconds();
    run();
    seconds.push_back(cpu_seconds() - begin);
    total += seconds.back();
  }
  return seconds;
}

}  // namespace moivre
