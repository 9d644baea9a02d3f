// SPDX-License-Identifier: MIT
// How do processes share a run that hear nothing of one another? Each does its part of every list,
// and keeps it; what they have kept is put together later.
//
// Part k of n does the jobs j of a list, numbered from 0, with j mod n = k - 1, and of these only
// what is not kept yet. A run goes no further than the lists of which other parts' jobs are
// missing: behind them it is asked to stop, as if it were interrupted. Where nothing is missing it
// goes on, so that after each putting together it comes to the next ones. A list that is too short
// to be shared is done by all.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "moivre/numeric/observations.h"

namespace moivre {

struct JobPart {
  std::uint64_t number = 1;  ///< from 1
  std::uint64_t of = 1;
};

class PartOfLists : public Observations {
 public:
  /// Kept in `kept`, which outlives it. stop_run: called behind lists of which other parts' jobs
  /// are missing, by any thread.
  PartOfLists(Observations& kept, JobPart part, std::function<void()> stop_run);

  std::map<std::uint64_t, std::string> recall(const Fingerprint& list) override;
  using Observations::keep;
  void keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) override;
  std::unique_ptr<JobShares> share(const Fingerprint& list, std::uint64_t jobs) override;
  void lists_are_done() override;

  /// Its part is done, and others' parts are missing.
  bool is_done() const { return is_done_; }

 private:
  Observations& kept_;
  JobPart part_;
  std::function<void()> stop_run_;
  std::atomic<bool> waits_for_others_{false};
  std::atomic<bool> is_done_{false};
};

}  // namespace moivre
