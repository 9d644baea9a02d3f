// SPDX-License-Identifier: MIT
// Every n-th job of a list, without those that are known.
#include "moivre/numeric/part_of_lists.h"

#include <mutex>
#include <utility>
#include <vector>

namespace moivre {
namespace {

class PartOfJobs : public JobShares {
 public:
  PartOfJobs(JobPart part, std::uint64_t jobs, std::atomic<bool>& waits_for_others)
      : part_(part),
        next_(part.number - 1),
        is_known_(jobs, false),
        waits_for_others_(waits_for_others) {}

  std::optional<std::uint64_t> draw() override {
    const std::lock_guard lock(mutex_);
    while (next_ < is_known_.size()) {
      const std::uint64_t job = next_;
      next_ += part_.of;
      if (!is_known_[job]) return job;
    }
    return std::nullopt;
  }

  bool tell(std::uint64_t job, std::string /*outcome*/) override {
    const std::lock_guard lock(mutex_);
    if (!is_known_[job]) ++known_;
    is_known_[job] = true;
    return true;
  }

  /// Nobody sends anything.
  std::optional<std::vector<ToldOutcome>> wait(const std::atomic<bool>& stop) override {
    if (!stop && known_ < is_known_.size()) waits_for_others_ = true;
    return std::nullopt;
  }

 private:
  JobPart part_;
  std::uint64_t next_;
  std::vector<bool> is_known_;
  std::uint64_t known_ = 0;
  std::atomic<bool>& waits_for_others_;
  std::mutex mutex_;
};

}  // namespace

PartOfLists::PartOfLists(Observations& kept, JobPart part, std::function<void()> stop_run)
    : kept_(kept), part_(part), stop_run_(std::move(stop_run)) {}

std::map<std::uint64_t, std::string> PartOfLists::recall(const Fingerprint& list) {
  return kept_.recall(list);
}

void PartOfLists::keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) {
  kept_.keep(list, outcomes);
}

std::unique_ptr<JobShares> PartOfLists::share(const Fingerprint& /*list*/, std::uint64_t jobs) {
  return std::make_unique<PartOfJobs>(part_, jobs, waits_for_others_);
}

void PartOfLists::lists_are_done() {
  if (!waits_for_others_) return;
  is_done_ = true;
  stop_run_();
}

}  // namespace moivre
