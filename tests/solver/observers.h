// SPDX-License-Identifier: MIT
// Who looks on while a list of jobs is done? One who remembers, up to a moment when he is killed;
// and a company whose members share the jobs.
#pragma once

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

#include "moivre/numeric/observations.h"

namespace moivre::test {

/// Keeps so many outcomes, and no more, as one who is killed does.
class Memory : public Observations {
 public:
  std::map<std::uint64_t, std::string> recall(const Fingerprint& list) override {
    const std::lock_guard lock(mutex_);
    return lists_[list];
  }
  using Observations::keep;
  void keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) override {
    const std::lock_guard lock(mutex_);
    if (kept_ < most) {
      for (const JobOutcome& outcome : outcomes) lists_[list][outcome.job] = outcome.bytes;
    }
    kept_ += outcomes.size();
  }

  /// How many were told since.
  std::uint64_t kept() const { return kept_; }
  void begin_again(std::uint64_t room) {
    kept_ = 0;
    most = room;
  }

 private:
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t kept_ = 0;
  std::mutex mutex_;
  std::map<Fingerprint, std::map<std::uint64_t, std::string>> lists_;
};

/// Some that solve the same in one process, each as if it were a process of its own.
class Company {
 public:
  struct List {
    std::uint64_t next = 0;
    std::vector<std::optional<std::string>> outcomes;
  };

  std::mutex mutex;
  std::map<Fingerprint, List> lists;
};

class Share : public JobShares {
 public:
  Share(Company& company, Company::List& list)
      : company_(company), list_(list), is_known_(list.outcomes.size(), false) {}

  std::optional<std::uint64_t> draw() override {
    const std::lock_guard lock(company_.mutex);
    if (list_.next == list_.outcomes.size()) return std::nullopt;
    ++drawn;
    return list_.next++;
  }
  bool tell(std::uint64_t job, std::string outcome) override {
    const std::lock_guard lock(company_.mutex);
    if (list_.outcomes[job] && !is_known_[job]) return false;
    list_.outcomes[job] = std::move(outcome);
    is_known_[job] = true;
    return true;
  }
  std::optional<std::vector<ToldOutcome>> wait(const std::atomic<bool>&) override {
    while (true) {
      const std::lock_guard lock(company_.mutex);
      std::vector<ToldOutcome> told;
      for (std::uint64_t job = 0; job < is_known_.size(); ++job) {
        if (is_known_[job] || !list_.outcomes[job]) continue;
        is_known_[job] = true;
        told.push_back({job, *list_.outcomes[job]});
      }
      if (!told.empty()) return told;
      if (std::find(is_known_.begin(), is_known_.end(), false) == is_known_.end()) {
        return std::nullopt;
      }
      std::this_thread::yield();
    }
  }

  static inline std::atomic<std::uint64_t> drawn{0};

 private:
  Company& company_;
  Company::List& list_;
  std::vector<bool> is_known_;
};

class OneOfCompany : public Observations {
 public:
  explicit OneOfCompany(Company& company) : company_(company) {}
  std::map<std::uint64_t, std::string> recall(const Fingerprint&) override { return {}; }
  void keep(const Fingerprint&, std::span<const JobOutcome>) override {}
  std::unique_ptr<JobShares> share(const Fingerprint& list, std::uint64_t jobs) override {
    const std::lock_guard lock(company_.mutex);
    Company::List& shared = company_.lists[list];
    shared.outcomes.resize(jobs);
    return std::make_unique<Share>(company_, shared);
  }

 private:
  Company& company_;
};

}  // namespace moivre::test
