// SPDX-License-Identifier: MIT
// Every quantity at every sample, its extremes, and time ratios of the outputs.
#include "moivre/design/readings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "extremes.h"
#include "time_ratio.h"

namespace moivre {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

using Table = std::vector<std::vector<double>>;

/// Along the branch angles that turn go on; the first is in (-pi, pi].
Table values_of(const MotionBranch& branch, const QuantityReader& reader) {
  Table table;
  for (const BranchSample& sample : branch.samples) {
    std::vector<double> row = reader.read(sample);
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (!reader.quantities()[k].turns) continue;
      const double beside = table.empty() ? 0 : table.back()[k];
      row[k] = beside + std::remainder(row[k] - beside, kTurn);
    }
    table.push_back(std::move(row));
  }
  return table;
}

/// A branch with its events, as a place to look for extremes.
class BranchCurves {
 public:
  BranchCurves(const MotionBranch& branch, const MotionResult& motion, const Table& table,
               const QuantityReader& reader)
      : branch_(branch), motion_(motion), table_(table), reader_(reader) {
    const auto& samples = branch.samples;
    const BranchSample* first = samples.empty() ? nullptr : &samples.front();
    const BranchSample* last = samples.empty() ? nullptr : &samples.back();
    if (const BranchEvent* begin = event_at(false)) poses_.push_back(pose_of(*begin, first));
    poses_.insert(poses_.end(), samples.begin(), samples.end());
    if (const BranchEvent* end = event_at(true)) poses_.push_back(pose_of(*end, last));
  }

  Extremes extremes(std::size_t k) const {
    const Series curve = curve_of(k);
    Extremes found{extreme_of(curve, -1), extreme_of(curve, 1)};
    // Between two events without a sample nothing is known of what is not known at both.
    const bool is_unknown = table_.empty() && std::any_of(curve.values.begin(), curve.values.end(),
                                                          [](double v) { return std::isnan(v); });
    if (is_unknown) found.least.value = found.largest.value = kUnknown;
    if (table_.empty()) return found;
    for (const bool is_end : {false, true}) {
      const BranchEvent* event = event_at(is_end);
      if (event == nullptr || event->kind != EventKind::dead_point) continue;
      if (!reader_.runs_away(k, event->q, event->time)) continue;
      const double beside = (is_end ? table_.back() : table_.front())[k];
      if (!(std::abs(beside) > 0)) continue;
      Extreme& end = beside > 0 ? found.largest : found.least;
      end = {std::copysign(std::numeric_limits<double>::infinity(), beside), event->time, false};
    }
    if (reader_.quantities()[k].group == QuantityGroup::advantage) find_pole(k, found.largest);
    return found;
  }

 private:
  const BranchEvent* event_at(bool is_end) const {
    const auto& index = is_end ? branch_.end_event : branch_.begin_event;
    return index ? &motion_.events[*index].at : nullptr;
  }

  /// The pose of an event. It has a velocity at a joint limit; at a bifurcation, which the branch
  /// passes smoothly, that of the parabola through the sample beside it.
  BranchSample pose_of(const BranchEvent& event, const BranchSample* beside) const {
    if (event.kind == EventKind::joint_limit) return reader_.sample_at(event.time, event.q);
    BranchSample pose;
    pose.time = event.time;
    pose.q = event.q;
    pose.is_determined = event.kind == EventKind::bifurcation && beside != nullptr &&
                         beside->is_determined && beside->velocity.size() > 0;
    if (!pose.is_determined) return pose;
    const double h = event.time - beside->time;
    pose.velocity = 2 / h * (event.q - beside->q) - beside->velocity;
    pose.acceleration = (pose.velocity - beside->velocity) / h;
    return pose;
  }

  double value_at_event(std::size_t k, bool is_end) const {
    if (reader_.quantities()[k].is_runaway && event_at(is_end)->kind != EventKind::joint_limit) {
      return kUnknown;
    }
    const double beside = table_.empty() ? 0 : (is_end ? table_.back() : table_.front())[k];
    return value_of(k, is_end ? poses_.back() : poses_.front(), beside);
  }

  double value_of(std::size_t k, const BranchSample& pose, double beside) const {
    const Quantity& quantity = reader_.quantities()[k];
    if (quantity.is_runaway && !pose.is_determined) return kUnknown;
    const double value = reader_.read(k, pose);
    return quantity.turns ? beside + std::remainder(value - beside, kTurn) : value;
  }

  Series curve_of(std::size_t k) const {
    Series curve;
    for (const BranchSample& pose : poses_) curve.times.push_back(pose.time);
    if (event_at(false) != nullptr) curve.values.push_back(value_at_event(k, false));
    for (const auto& row : table_) curve.values.push_back(row[k]);
    if (event_at(true) != nullptr) curve.values.push_back(value_at_event(k, true));
    for (const bool is_end : {false, true}) {
      if (event_at(is_end) != nullptr && poses_.size() > 1) take_limit(k, is_end, curve);
    }
    curve.at = [this, k, values = curve.values](double time) { return value_at(k, time, values); };
    return curve;
  }

  /// Where a quantity has no value at a singular pose itself, what it comes to.
  void take_limit(std::size_t k, bool is_end, Series& curve) const {
    // Of the way to the next sample. A branch comes to a dead point as a square root does, and to a
    // bifurcation straight.
    const bool is_dead_point = event_at(is_end)->kind == EventKind::dead_point;
    const double share = is_dead_point ? 1e-11 : 1e-5;
    const std::size_t at = is_end ? poses_.size() - 1 : 0;
    const std::size_t next = is_end ? at - 1 : 1;
    if (std::isfinite(curve.values[at]) || reader_.quantities()[k].is_runaway) return;
    const double time = poses_[at].time + share * (poses_[next].time - poses_[at].time);
    curve.values[at] = value_at(k, time, curve.values);
  }

  std::size_t interval_of(double time) const {
    const auto behind =
        std::upper_bound(poses_.begin() + 1, poses_.end() - 1, time,
                         [](double t, const BranchSample& sample) { return t < sample.time; });
    return static_cast<std::size_t>(behind - poses_.begin()) - 1;
  }

  double value_at(std::size_t k, double time, const std::vector<double>& values) const {
    const std::size_t j = interval_of(time);
    if (time == poses_[j].time) return values[j];
    if (time == poses_[j + 1].time) return values[j + 1];
    const BranchSample pose = reader_.between(poses_[j], poses_[j + 1], time);
    if (!pose.is_determined) return kUnknown;
    return value_of(k, pose, std::isfinite(values[j]) ? values[j] : values[j + 1]);
  }

  /// Where the output turns back, the advantage is infinite.
  void find_pole(std::size_t k, Extreme& largest) const {
    const auto& samples = branch_.samples;
    double before = kUnknown;
    for (std::size_t j = 0; j < samples.size(); ++j) {
      const double rate = reader_.rate(k, samples[j]);
      if (rate == 0 || before * rate < 0) {
        const double time = rate == 0 ? samples[j].time : pole_between(k, j - 1, before, rate);
        largest = {std::numeric_limits<double>::infinity(), time, true};
        return;
      }
      before = rate;
    }
  }

  /// The zero of the rate between samples j and j + 1, by false position.
  double pole_between(std::size_t k, std::size_t j, double low, double high) const {
    constexpr int kSteps = 8;
    double from = branch_.samples[j].time;
    double to = branch_.samples[j + 1].time;
    double time = from;
    for (int step = 0; step < kSteps; ++step) {
      time = from + (to - from) * low / (low - high);
      const BranchSample pose = reader_.between(branch_.samples[j], branch_.samples[j + 1], time);
      const double rate = pose.is_determined ? reader_.rate(k, pose) : 0;
      if (rate == 0 || !std::isfinite(rate)) break;
      // The end that stays counts half, so that both move (Illinois).
      if (rate * high < 0) {
        from = to;
        low = high;
      } else {
        low /= 2;
      }
      to = time;
      high = rate;
    }
    return time;
  }

  const MotionBranch& branch_;
  const MotionResult& motion_;
  const Table& table_;  ///< of the samples
  const QuantityReader& reader_;
  std::vector<BranchSample> poses_;  ///< the samples, and the events before and behind them
};

/// Transmission angles that are defined at no sample: the joint is none of a dyad.
std::vector<std::size_t> defined_quantities(const Readings& readings,
                                            const std::vector<Quantity>& all) {
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool is_defined =
        all[k].group != QuantityGroup::transmission ||
        std::any_of(readings.branches.begin(), readings.branches.end(),
                    [&](const BranchReadings& branch) {
                      return std::any_of(
                          branch.values.begin(), branch.values.end(),
                          [k](const std::vector<double>& row) { return std::isfinite(row[k]); });
                    });
    if (is_defined) kept.push_back(k);
  }
  return kept;
}

}  // namespace

Readings read_motion(const MotionResult& motion, const Mechanism& mechanism,
                     const QuantityReader& reader, bool with_extremes) {
  Readings readings;
  for (const MotionBranch& branch : motion.branches) {
    readings.branches.push_back({branch.id, values_of(branch, reader), {}, {}});
  }
  const std::vector<std::size_t> kept = defined_quantities(readings, reader.quantities());
  for (const std::size_t k : kept) readings.quantities.push_back(reader.quantities()[k]);
  for (std::size_t b = 0; with_extremes && b < motion.branches.size(); ++b) {
    BranchReadings& to = readings.branches[b];
    const BranchCurves curves(motion.branches[b], motion, to.values, reader);
    for (const std::size_t k : kept) to.extremes.push_back(curves.extremes(k));
    to.time_ratios = time_ratios(motion, motion.branches[b], mechanism, reader);
  }
  for (BranchReadings& branch : readings.branches) {
    for (std::vector<double>& row : branch.values) {
      std::vector<double> shown;
      for (const std::size_t k : kept) shown.push_back(row[k]);
      row = std::move(shown);
    }
  }
  return readings;
}

}  // namespace moivre
