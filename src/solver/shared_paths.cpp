// SPDX-License-Identifier: MIT
// A list of paths and its cycles as jobs of several processes, and the bytes that these tell one
// another.
#include "shared_paths.h"

#include <utility>

#include "moivre/numeric/bytes.h"

namespace moivre {
namespace {

/// What is told of a path.
enum class Told : std::uint8_t { has_ended, waits };

std::string told_of(std::string_view end) {
  ByteWriter bytes;
  bytes.put(Told::has_ended);
  bytes.put(end);
  return bytes.bytes();
}

std::string told_of(const WaitingPath& path) {
  ByteWriter bytes;
  bytes.put(Told::waits);
  bytes.put(std::string_view(bytes_of(path.endgame->end())));
  bytes.put(std::string_view(path.endgame->bytes_of_waiting()));
  return bytes.bytes();
}

/// Ends of a chain's sheets, told when all are there.
struct ChainEnds {
  std::size_t wanted = 0;
  std::size_t ended = 0;
  ByteWriter bytes = {};
};

}  // namespace

SharedPaths::SharedPaths(const PathProblem& problem, const PathList& paths, int tolerance_level,
                         int threads, const EndSink& sink, const std::atomic<bool>& stop,
                         Observations& observations, const Fingerprint& list)
    : problem_(problem),
      paths_(paths),
      tolerance_level_(tolerance_level),
      threads_(threads),
      sink_(sink),
      stop_(stop),
      observations_(observations),
      list_(list),
      options_(problem.endgame),
      kept_(problem, observations, list) {
  options_.may_wait = paths.count + paths.known > 1;
  for (std::uint64_t k = 0; k < paths.count; ++k) place_of_[paths.path_of(k)] = k;
}

bool SharedPaths::follow(JobShares& shares) {
  tell_known(shares);
  do_together(
      shares, stop_, [&] { follow_mine(shares); }, [&](const ToldOutcome& told) { take(told); });
  const bool all_came = known_ + kept_.ended() + waiting_.size() == paths_.count;
  if (!has_memory_ || stop_ || !all_came || waiting_.empty()) return has_memory_;
  walk_circles();
  if (has_memory_ && !stop_ && known_ + kept_.ended() == paths_.count) kept_.keep_circles();
  return has_memory_;
}

void SharedPaths::end(std::uint64_t path, PathEnd&& end, EndPart part) {
  kept_.take(path, end, part);
  sink_(path, std::move(end));
}

void SharedPaths::tell_known(JobShares& shares) {
  for (auto& [path, bytes] : observations_.recall(list_)) {
    const auto place = place_of_.find(path);
    if (place == place_of_.end()) continue;
    // Another process may have begun before this one had read what it knows.
    if (!shares.tell(place->second, told_of(std::string_view(bytes)))) continue;
    ++known_;
    sink_(path, end_of(bytes));
  }
}

void SharedPaths::follow_mine(JobShares& shares) {
  if (!has_memory_) return;
  PathList mine = paths_;
  mine.draw = [&shares] { return shares.draw(); };
  std::vector<WaitingPath> waiting;
  has_memory_ = track_until_they_wait(
      problem_, mine, tolerance_level_, threads_,
      [&](std::uint64_t path, PathEnd&& end) {
        const bool is_news =
            end.failure == Failure::cancelled ||
            shares.tell(place_of_.at(path), told_of(std::string_view(bytes_of(end))));
        if (is_news) this->end(path, std::move(end), EndPart::of_itself);
      },
      stop_, waiting);
  for (WaitingPath& path : waiting) {
    if (!shares.tell(place_of_.at(path.path), told_of(path))) continue;
    waiting_.push_back(std::move(path));
  }
}

void SharedPaths::take(const ToldOutcome& told) {
  const std::uint64_t path = paths_.path_of(told.job);
  ByteReader bytes(told.bytes);
  const Told what = bytes.get<Told>();
  PathEnd end = end_of(bytes.get_text());
  if (what == Told::has_ended) return this->end(path, std::move(end), EndPart::of_itself);
  auto endgame =
      std::make_unique<Endgame>(options_, problem_.plan.last().chart(), path, tolerance_level_);
  endgame->wait_as(bytes.get_text(), std::move(end));
  waiting_.push_back({path, std::move(endgame)});
}

void SharedPaths::walk_circles() {
  const auto chains = chains_among(waiting_);
  FingerprintMaker maker;
  maker.add(std::string_view("circles"));
  maker.add(list_.first);
  maker.add(list_.second);
  const auto shares = observations_.share(maker.fingerprint(), chains.size());
  if (!shares) return;
  do_together(
      *shares, stop_, [&] { walk_mine(*shares, chains); },
      [&](const ToldOutcome& told) {
        ByteReader bytes(told.bytes);
        while (!bytes.is_at_end()) {
          const auto path = bytes.get<std::uint64_t>();
          end(path, end_of(bytes.get_text()), EndPart::of_others_too);
        }
      });
}

void SharedPaths::walk_mine(JobShares& shares, const std::vector<SheetChain>& chains) {
  if (!has_memory_) return;
  std::map<std::uint64_t, std::uint64_t> chain_of;
  std::vector<ChainEnds> ends(chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c) {
    ends[c].wanted = chains[c].sheets.size();
    for (const std::size_t k : chains[c].sheets) chain_of[waiting_[k].path] = c;
  }
  has_memory_ = walk_cycles(
      problem_, waiting_, chains, [&shares] { return shares.draw(); }, threads_,
      [&](std::uint64_t path, PathEnd&& end) {
        const std::uint64_t chain = chain_of.at(path);
        ChainEnds& of = ends[chain];
        if (end.failure != Failure::cancelled) {
          of.bytes.put(path);
          of.bytes.put(std::string_view(bytes_of(end)));
          if (++of.ended == of.wanted) shares.tell(chain, of.bytes.bytes());
        }
        this->end(path, std::move(end), EndPart::of_others_too);
      },
      stop_);
}

}  // namespace moivre
