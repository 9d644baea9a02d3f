// SPDX-License-Identifier: MIT
// Which poses were solved before, here or by other processes? Their results are taken as they were
// observed, and only the others are solved.
//
// Private to the module.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "moivre/arms/arm_closures.h"
#include "moivre/numeric/fingerprint.h"

namespace moivre {

/// Arms at poses, each of which is a job.
struct ResultJobs {
  Fingerprint list;  ///< with observations
  std::size_t count = 0;
  std::size_t together = 1;  ///< so many are drawn, and solved, at a time
  std::function<const Eigen::Isometry3d&(std::size_t job)> pose;
  /// Results of these jobs; nullopt: not begun, since the run is to stop.
  std::function<std::vector<std::optional<ArmResult>>(std::span<const std::size_t> jobs)> solve;
  std::function<void()> tell;  ///< another one is there, that was not solved here and now
};

/// Hands on the results in the order of the jobs, with `options.observations` where there are any.
/// A set `stop` ends them before the first job that it cut short, which is not kept.
void observe_results(const ResultJobs& jobs, const Tracker& tracker, const SolveOptions& options,
                     const std::atomic<bool>& stop,
                     const std::function<void(ArmResult&& result)>& take);

/// What results depend on.
void add_to(FingerprintMaker& maker, const Arm& arm);
void add_to(FingerprintMaker& maker, const TypedPose& pose);
void add_to(FingerprintMaker& maker, const Tracker& tracker, const SolveOptions& options);

/// The exact bytes of a result, but for what was asked: pose, seed and tracker. Reading throws
/// std::invalid_argument where they are none.
std::string bytes_of(const ArmResult& result);
ArmResult arm_result_of(std::string_view bytes);

}  // namespace moivre
