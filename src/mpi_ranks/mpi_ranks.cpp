// SPDX-License-Identifier: MIT
// What is observed, on rank 0 with its ledger, and lists as they are seen by those that do their
// jobs.
#include "moivre/mpi_ranks/mpi_ranks.h"

#include "node.h"

namespace moivre {
namespace {

class SharesOfRanks : public JobShares {
 public:
  SharesOfRanks(SharedLists& lists, const Fingerprint& list, std::uint64_t jobs)
      : lists_(lists), key_(lists.open(list, jobs)) {}
  ~SharesOfRanks() override { lists_.close(key_); }
  SharesOfRanks(const SharesOfRanks&) = delete;
  SharesOfRanks& operator=(const SharesOfRanks&) = delete;

  std::optional<std::uint64_t> draw() override { return lists_.draw(key_); }
  bool tell(std::uint64_t job, std::string outcome) override {
    return lists_.tell(key_, job, std::move(outcome));
  }
  std::optional<std::vector<ToldOutcome>> wait(const std::atomic<bool>& stop) override {
    return lists_.wait(key_, stop);
  }

 private:
  SharedLists& lists_;
  ListKey key_;
};

}  // namespace

MpiRanks::MpiRanks(int* argc, char*** argv, std::function<void()> when_over)
    : node_(std::make_unique<Node>(argc, argv, std::move(when_over))) {}

MpiRanks::~MpiRanks() = default;

int MpiRanks::rank() const { return node_->rank(); }

int MpiRanks::ranks() const { return node_->ranks(); }

RankTraffic MpiRanks::traffic() const { return node_->traffic(); }

void MpiRanks::keep_in(Observations* ledger) { ledger_ = ledger; }

int MpiRanks::end(int exit_code) { return node_->end(exit_code); }

std::map<std::uint64_t, std::string> MpiRanks::recall(const Fingerprint& list) {
  if (ledger_ == nullptr) return {};
  return ledger_->recall(list);
}

void MpiRanks::keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) {
  if (ledger_ != nullptr) ledger_->keep(list, outcomes);
}

std::unique_ptr<JobShares> MpiRanks::share(const Fingerprint& list, std::uint64_t jobs) {
  return std::make_unique<SharesOfRanks>(node_->lists(), list, jobs);
}

}  // namespace moivre
