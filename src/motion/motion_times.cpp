// SPDX-License-Identifier: MIT
// Even times of samples and checkpoints, merged.
#include "motion_times.h"

#include <algorithm>
#include <iterator>

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

/// As it stands among the samples, where one is the same but for rounding.
double snapped(double time, const std::vector<double>& samples) {
  constexpr double kTimeRounding = 1e-12;
  const double width = kTimeRounding * (samples.back() - samples.front());
  const auto next = std::lower_bound(samples.begin(), samples.end(), time - width);
  return next != samples.end() && *next <= time + width ? *next : time;
}

}  // namespace

bool MotionTimes::is_sample(double time) const {
  return std::binary_search(samples.begin(), samples.end(), time);
}

MotionTimes motion_times(const MotionOptions& options, int checkpoints) {
  MotionTimes times;
  times.from = options.from;
  times.to = options.to;
  times.samples = even_times(options, options.steps);
  times.checkpoints =
      checkpoints == 0 ? std::vector{options.from} : even_times(options, checkpoints);
  for (double& time : times.checkpoints) time = snapped(time, times.samples);
  std::set_union(times.samples.begin(), times.samples.end(), times.checkpoints.begin(),
                 times.checkpoints.end(), std::back_inserter(times.all));
  return times;
}

std::string at_time(double time) { return "at t = " + std::to_string(time) + " s"; }

}  // namespace moivre
