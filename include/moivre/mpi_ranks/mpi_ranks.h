// SPDX-License-Identifier: MIT
// How do the processes that mpirun or srun has started do the jobs of one run together?
//
// Every rank runs the same command. Where it comes to a list of jobs (moivre/numeric/job_shares.h),
// rank 0 says who does which, in pieces that become smaller towards the end; outcomes go to rank 0,
// and from there down a binary tree to all. Rank 0 alone is asked for what its ledger knows, and is
// told what to keep.
//
//   rank r --piece wanted, outcomes--> rank 0 --pieces--> rank r
//                                      rank 0 --outcomes--> 1, 2;  r --outcomes--> 2r + 1, 2r + 2
//
// A rank that ends before the others gives back what it has begun. When rank 0 ends, the others do.
// Decisions of rank 0 alone count, so that ranks that have drifted apart would cost time, and
// change nothing.
#pragma once

#include <functional>
#include <memory>

#include "moivre/numeric/observations.h"

namespace moivre {

/// What one rank has sent, received and waited.
struct RankTraffic {
  std::uint64_t messages = 0;  ///< sent
  std::uint64_t bytes = 0;     ///< sent
  double cpu = 0;  ///< seconds, of the thread that sends and receives, since MPI has begun
};

class MpiRanks : public Observations {
 public:
  /// when_over: called from another thread, on a rank other than 0, when rank 0 has ended and MPI
  /// with it. Nothing that this rank still does is of use then.
  MpiRanks(int* argc, char*** argv, std::function<void()> when_over);
  /// Ends the part of this process.
  ~MpiRanks() override;
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  int rank() const;
  int ranks() const;
  RankTraffic traffic() const;

  /// Where rank 0 keeps what is observed; nullptr: nowhere. Not owned.
  void keep_in(Observations* ledger);
  /// This rank has come to its end, with that exit code: rank 0 when all is written; another one
  /// then waits for rank 0. Returns, on rank 0, how many of the others have ended with an error of
  /// theirs alone.
  int end(int exit_code);

  std::map<std::uint64_t, std::string> recall(const Fingerprint& list) override;
  using Observations::keep;
  void keep(const Fingerprint& list, std::span<const JobOutcome> outcomes) override;
  std::unique_ptr<JobShares> share(const Fingerprint& list, std::uint64_t jobs) override;

  class Node;

 private:
  std::unique_ptr<Node> node_;
  Observations* ledger_ = nullptr;
};

}  // namespace moivre
