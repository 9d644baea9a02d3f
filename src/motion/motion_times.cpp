// SPDX-License-Identifier: MIT
// Even times of samples and checkpoints, merged.
#include "motion_times.h"

#include <algorithm>
#include <cmath>

namespace moivre {
namespace {

/// from + k (to - from) / steps.
std::vector<double> even_times(const MotionOptions& options, int steps) {
  std::vector<double> times;
  for (int k = 0; k <= steps; ++k) {
    times.push_back(options.from + (options.to - options.from) * k / steps);
  }
  times.back() = options.to;
  return times;
}

/// Both, ascending; what is the same but for rounding once, as in `a`.
std::vector<double> merged(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kTimeRounding = 1e-12;
  const double width = kTimeRounding * (a.back() - a.front());
  std::vector<double> all = a;
  for (const double time : b) {
    const auto next = std::lower_bound(a.begin(), a.end(), time - width);
    if (next == a.end() || *next > time + width) all.push_back(time);
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

double MotionTimes::fine(int k) const {
  const double even = from + (to - from) * k / std::max(1, fine_steps);
  return *std::min_element(all.begin(), all.end(), [&](double a, double b) {
    return std::abs(a - even) < std::abs(b - even);
  });
}

bool MotionTimes::is_sample(double time) const {
  return std::binary_search(samples.begin(), samples.end(), time);
}

MotionTimes motion_times(const MotionOptions& options, int checkpoints) {
  MotionTimes times;
  times.from = options.from;
  times.to = options.to;
  times.fine_steps = checkpoints * kFiner;
  times.samples = even_times(options, options.steps);
  times.all = times.fine_steps == 0 ? times.samples
                                    : merged(times.samples, even_times(options, times.fine_steps));
  return times;
}

std::string at_time(double time) { return "at t = " + std::to_string(time) + " s"; }

}  // namespace moivre
