// SPDX-License-Identifier: MIT
// One mutex for all lists of a rank: a job takes many times as long as anything here.
#include "shared_lists.h"

#include <utility>

namespace moivre {
namespace {

// Outcomes wait so long for others to go with them, unless somebody waits for them.
constexpr std::chrono::milliseconds kGather{20};
// The next piece is asked for with the last job of this one; but not near the end, where a job
// would lie here that others have time for.
constexpr std::uint64_t kLeastToAskAhead = 8;
// A stop is seen so soon.
constexpr std::chrono::milliseconds kLookForStop{10};

}  // namespace

SharedLists::List& SharedLists::list_of(const ListKey& key, std::uint64_t jobs) {
  const auto [place, is_new] = lists_.try_emplace(key);
  List& list = place->second;
  if (is_new) {
    list.jobs = list.left = jobs;
    list.told.assign(jobs, false);
  }
  return list;
}

ListKey SharedLists::open(const Fingerprint& list, std::uint64_t jobs) {
  const std::lock_guard lock(mutex_);
  const ListKey key{list, times_[list]++};
  list_of(key, jobs).is_open = true;
  return key;
}

// Only outcomes that are to go to others outlive it.
void SharedLists::close(const ListKey& key) {
  const std::lock_guard lock(mutex_);
  List& list = lists_.at(key);
  if (list.to_tell.empty()) {
    lists_.erase(key);
    return;
  }
  list.is_open = false;
  list.is_urgent = is_news_ = true;
  for_speaker_.notify_one();
}

void SharedLists::ask(List& list) {
  if (list.is_asking) return;
  list.is_asking = is_news_ = true;
  for_speaker_.notify_one();
}

std::optional<std::uint64_t> SharedLists::draw(const ListKey& key) {
  std::unique_lock lock(mutex_);
  List& list = lists_.at(key);
  while (!is_over_ && list.left > 0) {
    while (list.piece.count > 0) {
      --list.piece.count;
      const std::uint64_t job = list.piece.first++;
      if (list.piece.count == 0 && list.size_of_piece >= kLeastToAskAhead) ask(list);
      if (!list.told[job]) return job;
    }
    if (list.none_free) return std::nullopt;
    ask(list);
    for_workers_.wait(lock);
  }
  return std::nullopt;
}

bool SharedLists::tell(const ListKey& key, std::uint64_t job, std::string outcome) {
  const std::lock_guard lock(mutex_);
  List& list = lists_.at(key);
  if (list.told.at(job)) return false;
  list.told[job] = true;
  --list.left;
  if (list.to_tell.empty()) list.first_to_tell = std::chrono::steady_clock::now();
  list.to_tell.push_back({job, std::move(outcome)});
  return true;
}

std::optional<std::vector<ToldOutcome>> SharedLists::wait(const ListKey& key,
                                                          const std::atomic<bool>& stop) {
  std::unique_lock lock(mutex_);
  List& list = lists_.at(key);
  if (!list.to_tell.empty()) {
    list.is_urgent = is_news_ = true;
    for_speaker_.notify_one();
  }
  while (true) {
    if (!list.arrived.empty()) return std::exchange(list.arrived, {});
    if (list.left == 0 || is_over_ || stop) return std::nullopt;
    if (!list.none_free) return std::vector<ToldOutcome>{};
    for_workers_.wait_for(lock, kLookForStop);
  }
}

void SharedLists::take_piece(const ListKey& key, JobPiece piece) {
  const std::lock_guard lock(mutex_);
  const auto found = lists_.find(key);
  if (found == lists_.end()) return;
  List& list = found->second;
  list.piece = piece;
  list.size_of_piece = piece.count;
  list.none_free = piece.count == 0;
  list.is_asking = list.has_asked = false;
  for_workers_.notify_all();
}

void SharedLists::take_outcomes(const ListKey& key, std::uint64_t jobs,
                                std::vector<ToldOutcome> outcomes) {
  const std::lock_guard lock(mutex_);
  List& list = list_of(key, jobs);
  for (ToldOutcome& outcome : outcomes) {
    if (list.told.at(outcome.job)) continue;
    list.told[outcome.job] = true;
    --list.left;
    list.arrived.push_back(std::move(outcome));
  }
  for_workers_.notify_all();
}

void SharedLists::set_free(const ListKey& key) {
  const std::lock_guard lock(mutex_);
  const auto found = lists_.find(key);
  if (found == lists_.end()) return;
  found->second.none_free = false;
  for_workers_.notify_all();
}

void SharedLists::set_over() {
  const std::lock_guard lock(mutex_);
  is_over_ = true;
  for_workers_.notify_all();
}

bool SharedLists::is_over() {
  const std::lock_guard lock(mutex_);
  return is_over_;
}

std::vector<PieceWanted> SharedLists::wanted() {
  const std::lock_guard lock(mutex_);
  std::vector<PieceWanted> pieces;
  for (auto& [key, list] : lists_) {
    if (!list.is_asking || list.has_asked) continue;
    list.has_asked = true;
    pieces.push_back({key, list.jobs});
  }
  return pieces;
}

std::vector<OutgoingOutcomes> SharedLists::outgoing(std::chrono::steady_clock::time_point now) {
  const std::lock_guard lock(mutex_);
  is_news_ = false;
  std::vector<OutgoingOutcomes> all;
  for (auto place = lists_.begin(); place != lists_.end();) {
    const auto here = place++;
    List& list = here->second;
    const bool is_due = list.is_urgent || now - list.first_to_tell > kGather;
    if (list.to_tell.empty() || !is_due) continue;
    all.push_back({here->first, list.jobs, std::exchange(list.to_tell, {})});
    list.is_urgent = false;
    if (!list.is_open) lists_.erase(here);
  }
  return all;
}

void SharedLists::sleep(std::chrono::microseconds most) {
  std::unique_lock lock(mutex_);
  for_speaker_.wait_for(lock, most, [this] { return is_news_; });
}

}  // namespace moivre
