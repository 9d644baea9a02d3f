// SPDX-License-Identifier: MIT
// The one thread of a rank that calls MPI: what does it send, and what does it do with what it
// receives?
#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include "job_board.h"
#include "moivre/mpi_ranks/mpi_ranks.h"
#include "shared_lists.h"

namespace moivre {

class MpiRanks::Node {
 public:
  /// Returns when MPI has begun.
  Node(int* argc, char*** argv, std::function<void()> when_over);
  /// Returns when MPI has ended.
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }
  RankTraffic traffic() const;
  SharedLists& lists() { return lists_; }
  /// Of MpiRanks::end().
  int end(int exit_code);

 private:
  class Speaker;
  void run(int* argc, char*** argv, std::atomic<bool>& has_begun);

  std::function<void()> when_over_;
  int rank_ = 0;
  int ranks_ = 1;
  SharedLists lists_;
  std::atomic<bool> is_ending_{false};
  std::atomic<int> exit_code_{0};
  std::atomic<int> failed_{0};
  std::atomic<std::uint64_t> messages_{0};
  std::atomic<std::uint64_t> bytes_{0};
  std::atomic<double> cpu_{0};
  std::thread thread_;
};

}  // namespace moivre
