// SPDX-License-Identifier: MIT
// An arm for each value, and their answers one after the other.
#include "moivre/arms/held_range.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "moivre/numeric/invalid_input.h"
#include "observed_results.h"

namespace moivre {

std::vector<double> values_of(const HeldRange& range) {
  constexpr std::size_t kMost = 1'000'000;
  if (!std::isfinite(range.from) || !std::isfinite(range.to)) {
    throw InvalidInput("the values at which " + range.joint + " is held are finite");
  }
  if (range.count == 0 || range.count > kMost) {
    throw InvalidInput("the number of values at which " + range.joint +
                       " is held is from 1 to a million");
  }
  std::vector<double> values(range.count, range.from);
  const double steps = static_cast<double>(std::max<std::size_t>(range.count, 2) - 1);
  for (std::size_t k = 1; k < range.count; ++k) {
    values[k] = range.from + (range.to - range.from) * (static_cast<double>(k) / steps);
  }
  return values;
}

std::vector<Arm> arms_along(const Robot& robot, const ArmChoice& choice, const HeldRange& range) {
  const bool is_held = std::any_of(choice.held.begin(), choice.held.end(),
                                   [&](const HeldJoint& held) { return held.name == range.joint; });
  if (is_held) {
    throw std::invalid_argument(range.joint + " is held at one value and at many");
  }
  std::vector<Arm> arms;
  for (const double value : values_of(range)) {
    ArmChoice held = choice;
    held.held.push_back({range.joint, value});
    arms.push_back(make_arm(robot, held));
  }
  return arms;
}

std::vector<ArmResult> find_closures_of_each(const std::vector<Arm>& arms, const TypedPose& pose,
                                             const Tracker& tracker, const SolveOptions& options,
                                             const std::atomic<bool>& stop) {
  Progress progress;
  progress.total = arms.size();
  SolveOptions of_each = options;
  of_each.progress = nullptr;
  of_each.observations = nullptr;  // whole results are kept
  FingerprintMaker maker;
  maker.add(std::string_view("arms"));
  for (const Arm& arm : arms) add_to(maker, arm);
  add_to(maker, pose);
  add_to(maker, tracker, options);
  ResultJobs jobs;
  jobs.list = maker.fingerprint();
  jobs.count = arms.size();
  jobs.pose = [&](std::size_t) -> const Eigen::Isometry3d& { return pose.pose; };
  jobs.tell = [&] {
    progress.finite = ++progress.done;
    if (options.progress) options.progress(progress);
  };
  jobs.solve = [&](std::span<const std::size_t> some) {
    std::vector<std::optional<ArmResult>> results(some.size());
    for (std::size_t k = 0; k < some.size() && !stop; ++k) {
      results[k] = find_arm_closures(arms[some[k]], pose, tracker, of_each, stop);
      jobs.tell();
    }
    return results;
  };
  std::vector<ArmResult> results;
  observe_results(jobs, tracker, options, stop,
                  [&](ArmResult&& result) { results.push_back(std::move(result)); });
  return results;
}

}  // namespace moivre
