// SPDX-License-Identifier: MIT
// What does one rank know of the lists that it does with others? Its piece of each, and which
// outcomes have been exchanged.
//
// Stands between the threads that do jobs and the one that speaks with other ranks: those wait
// here, that one looks in. Outcomes of a list that this rank has not come to yet are kept until it
// does.
#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "job_board.h"
#include "moivre/numeric/job_shares.h"

namespace moivre {

/// Outcomes of one list that were found here and are to go to the others.
struct OutgoingOutcomes {
  ListKey key;
  std::uint64_t jobs = 0;
  std::vector<ToldOutcome> outcomes;
};

/// A list of which a piece is wanted.
struct PieceWanted {
  ListKey key;
  std::uint64_t jobs = 0;
};

class SharedLists {
 public:
  // Of the threads that do jobs:
  /// The list, once more.
  ListKey open(const Fingerprint& list, std::uint64_t jobs);
  void close(const ListKey& key);
  std::optional<std::uint64_t> draw(const ListKey& key);
  /// False where its outcome has arrived from another rank.
  bool tell(const ListKey& key, std::uint64_t job, std::string outcome);
  std::optional<std::vector<ToldOutcome>> wait(const ListKey& key, const std::atomic<bool>& stop);

  // Of the thread that speaks with others:
  void take_piece(const ListKey& key, JobPiece piece);
  void take_outcomes(const ListKey& key, std::uint64_t jobs, std::vector<ToldOutcome> outcomes);
  /// There are jobs to draw again.
  void set_free(const ListKey& key);
  /// No other rank will say anything any more.
  void set_over();
  bool is_over();
  std::vector<PieceWanted> wanted();
  /// Those that have waited long enough, or that somebody waits for.
  std::vector<OutgoingOutcomes> outgoing(std::chrono::steady_clock::time_point now);
  /// Until something is wanted or sent urgently, at most so long.
  void sleep(std::chrono::microseconds most);

 private:
  struct List {
    std::uint64_t jobs = 0;
    bool is_open = false;
    JobPiece piece;
    std::uint64_t size_of_piece = 0;  ///< when it came
    bool is_asking = false;           ///< for a piece
    bool has_asked = false;           ///< and the thread that speaks knows
    bool none_free = false;
    std::vector<bool> told;
    std::uint64_t left = 0;
    std::vector<ToldOutcome> arrived;
    std::vector<ToldOutcome> to_tell;
    std::chrono::steady_clock::time_point first_to_tell;
    bool is_urgent = false;
  };
  List& list_of(const ListKey& key, std::uint64_t jobs);
  void ask(List& list);

  std::mutex mutex_;
  std::condition_variable for_workers_, for_speaker_;
  bool is_news_ = false;  ///< for the thread that speaks
  bool is_over_ = false;
  std::map<Fingerprint, std::uint64_t> times_;
  std::map<ListKey, List> lists_;
};

}  // namespace moivre
