// SPDX-License-Identifier: MIT
// Blocks of jobs, alone or drawn among other processes.
#include "moivre/numeric/job_list.h"

#include <algorithm>
#include <memory>

namespace moivre {
namespace {

/// Jobs on their way to what is observed of them.
struct JobsUnderWay {
  const JobList& jobs;
  Observations& observations;
  const std::atomic<bool>& stop;
  std::unique_ptr<JobShares> shares;  ///< nullptr: this process is alone

  /// Those of which nothing is known.
  std::vector<std::size_t> take_known() {
    std::vector<std::size_t> others;
    auto known = observations.recall(jobs.fingerprint);
    for (std::size_t job = 0; job < jobs.count; ++job) {
      const auto found = known.find(job);
      if (found == known.end()) {
        others.push_back(job);
        continue;
      }
      // Another process may have begun before this one had read what it knows.
      if (!shares || shares->tell(job, found->second)) jobs.take(job, found->second);
    }
    return others;
  }

  void solve(std::span<const std::size_t> numbers) {
    for (JobOutcome& outcome : jobs.solve(numbers)) {
      observations.keep(jobs.fingerprint, outcome);
      if (shares) shares->tell(outcome.job, std::move(outcome.bytes));
    }
  }

  void solve_all(std::span<const std::size_t> numbers) {
    for (std::size_t begin = 0; begin < numbers.size(); begin += jobs.block) {
      solve(numbers.subspan(begin, std::min(jobs.block, numbers.size() - begin)));
    }
  }

  void solve_drawn() {
    while (!stop) {
      std::vector<std::size_t> drawn;
      while (drawn.size() < jobs.drawn_block) {
        const auto job = shares->draw();
        if (!job) break;
        drawn.push_back(*job);
      }
      if (drawn.empty()) return;
      solve(drawn);
    }
  }

  void take_told(const ToldOutcome& told) {
    const OutcomeKind kind = jobs.take(told.job, told.bytes);
    observations.keep(jobs.fingerprint, JobOutcome{told.job, told.bytes, kind});
  }
};

}  // namespace

void do_jobs(const JobList& jobs, Observations& observations, const std::atomic<bool>& stop) {
  JobsUnderWay under_way{
      jobs, observations, stop,
      jobs.count > 1 ? observations.share(jobs.fingerprint, jobs.count) : nullptr};
  const std::vector<std::size_t> others = under_way.take_known();
  if (!under_way.shares) return under_way.solve_all(others);
  do_together(
      *under_way.shares, stop, [&] { under_way.solve_drawn(); },
      [&](const ToldOutcome& told) { under_way.take_told(told); });
}

}  // namespace moivre
