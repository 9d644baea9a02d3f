// SPDX-License-Identifier: MIT
// Even times of samples and checkpoints, merged; which are refused; where the drivers stand then,
// and when they have shown all.
#include "motion_times.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "moivre/mechanism/rules.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

// More samples than a plot shows, or a table is read by, only cost memory.
constexpr int kMostSamples = 1000000;

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

/// Seconds from `from` until the angle has gone one turn on; nullopt where it comes to a halt
/// before.
std::optional<double> time_of_a_turn(const Parabola& angle, double from) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double velocity = angle.velocity + angle.acceleration * from;
  const double acceleration = angle.acceleration * (velocity < 0 ? -1 : 1);
  // |velocity| d + acceleration d^2 / 2 = a turn, in the form that does not cancel.
  const double square = velocity * velocity + 2 * acceleration * kTurn;
  if (square < 0) return std::nullopt;
  const double sum = std::abs(velocity) + std::sqrt(square);
  if (!(sum > 0)) return std::nullopt;
  return 2 * kTurn / sum;
}

}  // namespace

bool MotionTimes::is_sample(double time) const {
  return std::binary_search(samples.begin(), samples.end(), time);
}

MotionTimes motion_times(const MotionOptions& options, int checkpoints) {
  MotionTimes times;
  times.samples = even_times(options, options.steps);
  times.checkpoints =
      checkpoints == 0 ? std::vector{options.from} : even_times(options, checkpoints);
  for (double& time : times.checkpoints) time = snapped(time, times.samples);
  std::set_union(times.samples.begin(), times.samples.end(), times.checkpoints.begin(),
                 times.checkpoints.end(), std::back_inserter(times.all));
  return times;
}

std::vector<std::string> validate(const MotionOptions& options) {
  std::vector<std::string> broken;
  if (!std::isfinite(options.from) || !std::isfinite(options.to) || !(options.to > options.from)) {
    broken.emplace_back("`to` must be later than `from`, both finite");
  }
  if (options.steps < 1 || options.steps > kMostSamples) {
    broken.emplace_back("`steps` must lie between 1 and a million");
  }
  if (options.checkpoints < 0 || options.checkpoints > kMostSamples) {
    broken.emplace_back("`checkpoints` must lie between 0 and a million");
  }
  for (const std::string& rule : validate(options.branch)) broken.push_back("branch." + rule);
  return broken;
}

void require_workable(const Mechanism& mechanism, const MotionOptions& options) {
  require_unbroken(validate(options));
  for (const double time : {options.from, options.to}) require_drivers(mechanism, time);
}

std::vector<double> driver_values(const Mechanism& mechanism, double time) {
  if (!std::isfinite(time)) throw InvalidInput("the time of the drivers must be finite");
  std::vector<double> values;
  for (const Driver& driver : mechanism.drivers) {
    require_law(driver.law);
    values.push_back(driver_state(driver.law, time).value);
  }
  return values;
}

double natural_duration(const Mechanism& mechanism, double from) {
  require_form(mechanism);
  if (!std::isfinite(from)) throw InvalidInput("`from` must be finite");
  for (const Driver& driver : mechanism.drivers) {
    if (const auto* spline = std::get_if<Spline>(&driver.law)) {
      if (spline->t.back() > from) return spline->t.back() - from;
    }
    const auto* parabola = std::get_if<Parabola>(&driver.law);
    if (parabola == nullptr || kind_of(mechanism, driver) != CoordinateKind::angle) continue;
    if (const auto duration = time_of_a_turn(*parabola, from)) return *duration;
  }
  return 1;
}

}  // namespace moivre
