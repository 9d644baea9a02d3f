// SPDX-License-Identifier: MIT
// Which jobs of a list were done before, here or by other processes? Their outcomes are taken, and
// only the others are done.
//
// What is known is sent to other processes too, where there are any; what is done is kept, and sent
// to them. A set `stop` ends it at the next block.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "moivre/numeric/observations.h"

namespace moivre {

/// Jobs, numbered from 0, and how they are done.
struct JobList {
  Fingerprint fingerprint;
  std::size_t count = 0;
  std::size_t block = 1;        ///< so many are done at a time by a process that is alone
  std::size_t drawn_block = 1;  ///< and by one among others
  /// Takes what came of a job, as it was kept or told; its kind.
  std::function<OutcomeKind(std::size_t job, std::string_view outcome)> take;
  /// Does these jobs; what came of them, but for those that a stop cut short.
  std::function<std::vector<JobOutcome>(std::span<const std::size_t> jobs)> solve;
};

/// Every job is taken or solved once.
void do_jobs(const JobList& jobs, Observations& observations, const std::atomic<bool>& stop);

}  // namespace moivre
