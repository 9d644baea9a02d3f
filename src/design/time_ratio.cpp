// SPDX-License-Identifier: MIT
// The output's least and largest value over a turn of the driver, taken as a cycle.
#include "time_ratio.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "extremes.h"
#include "observable.h"

namespace moivre {
namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;
// Of the range: what is nearer has come back.
constexpr double kBack = 1e-6;

/// Seconds a turn of the only driver; nullopt where there is none at constant speed.
std::optional<double> period_of(const Mechanism& mechanism) {
  if (mechanism.drivers.size() != 1) return std::nullopt;
  const Driver& driver = mechanism.drivers.front();
  const auto* law = std::get_if<Parabola>(&driver.law);
  const bool turns = kind_of(mechanism, driver) == CoordinateKind::angle;
  if (law == nullptr || !turns || law->acceleration != 0 || law->velocity == 0) return std::nullopt;
  return kWholeTurn / std::abs(law->velocity);
}

/// The first turn of a branch.
class Cycle {
 public:
  Cycle(const MotionBranch& branch, double period, const QuantityReader& reader)
      : samples_(branch.samples), from_(samples_.front().time), period_(period), reader_(reader) {}

  std::optional<TimeRatio> ratio(const Observable& output) const {
    const Series curve = cycle_of(output);
    const std::size_t size = curve.values.size();
    if (size < 5) return std::nullopt;
    const Extreme least = extreme_of(curve, -1);
    const Extreme largest = extreme_of(curve, 1);
    const double range = largest.value - least.value;
    const double back = curve.values.back() - curve.values[1];
    const double scale = std::max(std::abs(largest.value), std::abs(least.value));
    if (!(range > kBack * scale) || !(std::abs(back) < kBack * range)) return std::nullopt;
    double rising = std::fmod(largest.time - least.time, period_);
    if (rising < 0) rising += period_;
    const double falling = period_ - rising;
    if (!(rising > 0 && falling > 0)) return std::nullopt;
    return TimeRatio{output.name,    std::max(rising, falling) / std::min(rising, falling),
                     rising,         falling,
                     least.value,    largest.value,
                     output.is_angle};
  }

 private:
  double value_of(const Observable& output, const Eigen::VectorXd& q) const {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(q.size());
    return output.state(q, rest, rest).value;
  }

  double value_at(const Observable& output, double time) const {
    while (time > samples_.back().time) time -= period_;
    while (time < from_) time += period_;
    const auto behind =
        std::upper_bound(samples_.begin() + 1, samples_.end() - 1, time,
                         [](double t, const BranchSample& sample) { return t < sample.time; });
    return value_of(output, reader_.between(*(behind - 1), *behind, time).q);
  }

  /// The pose a turn behind the first one, from the samples beside it; it need not be the first one
  /// again.
  BranchSample pose_a_turn_later(const BranchSample& before, const BranchSample& after) const {
    const double time = from_ + period_;
    return after.time <= time + kBack * period_ ? after : reader_.between(before, after, time);
  }

  /// The samples of the turn, the last one before them and the first one behind, so that no extreme
  /// is at an end.
  Series cycle_of(const Observable& output) const {
    Series curve;
    const double tiny = kBack * period_;
    const auto add = [&](double time, const Eigen::VectorXd& q) {
      curve.times.push_back(time);
      curve.values.push_back(value_of(output, q));
    };
    std::size_t last = 0;
    while (last + 1 < samples_.size() && samples_[last + 1].time < from_ + period_ - tiny) ++last;
    add(samples_[last].time - period_, samples_[last].q);
    for (std::size_t k = 0; k <= last; ++k) add(samples_[k].time, samples_[k].q);
    add(from_ + period_, pose_a_turn_later(samples_[last], samples_[last + 1]).q);
    if (output.is_angle) go_on(curve.values);
    curve.at = [this, output, times = curve.times, values = curve.values](double time) {
      const double value = value_at(output, time);
      if (!output.is_angle) return value;
      const auto behind = std::upper_bound(times.begin() + 1, times.end(), time);
      const double beside = values[static_cast<std::size_t>(behind - times.begin()) - 1];
      return beside + std::remainder(value - beside, kWholeTurn);
    };
    return curve;
  }

  /// Angles without the jumps at half a turn.
  static void go_on(std::vector<double>& angles) {
    for (std::size_t k = 1; k < angles.size(); ++k) {
      angles[k] = angles[k - 1] + std::remainder(angles[k] - angles[k - 1], kWholeTurn);
    }
  }

  const std::vector<BranchSample>& samples_;
  double from_;
  double period_;
  const QuantityReader& reader_;
};

}  // namespace

std::vector<TimeRatio> time_ratios(const MotionResult& motion, const MotionBranch& branch,
                                   const Mechanism& mechanism, const QuantityReader& reader) {
  std::vector<TimeRatio> ratios;
  const std::optional<double> period = period_of(mechanism);
  if (!period || branch.samples.size() < 3) return ratios;
  const double tiny = kBack * *period;
  const bool is_whole = branch.samples.front().time <= motion.from + tiny &&
                        branch.samples.back().time >= motion.from + *period - tiny;
  if (!is_whole) return ratios;
  const Cycle cycle(branch, *period, reader);
  for (const std::string& name : reader.outputs()) {
    if (auto ratio = cycle.ratio(output_observable(mechanism, name))) ratios.push_back(*ratio);
  }
  return ratios;
}

}  // namespace moivre
