// SPDX-License-Identifier: MIT
// How do several processes follow the paths of one list, so that each goes on as if it had followed
// them all?
//
//   first   paths, one by one: each process those that it draws. Told: an end, or where the path
//           waits after its first turn
//   then    the chains among those that wait, which all processes find alike: each walks those that
//           it draws. Told: their ends
//
// So a path waits for those that it would wait for in one process, whoever follows them.
#pragma once

#include <map>

#include "moivre/endgame/endgame.h"
#include "observed_paths.h"

namespace moivre {

class SharedPaths {
 public:
  SharedPaths(const PathProblem& problem, const PathList& paths, int tolerance_level, int threads,
              const EndSink& sink, const std::atomic<bool>& stop, Observations& observations,
              const Fingerprint& list);
  /// As track_paths().
  bool follow(JobShares& shares);

 private:
  void tell_known(JobShares& shares);
  void follow_mine(JobShares& shares);
  void take(const ToldOutcome& told);
  void walk_circles();
  void walk_mine(JobShares& shares, const std::vector<SheetChain>& chains);
  void end(std::uint64_t path, PathEnd&& end, EndPart part);

  const PathProblem& problem_;
  const PathList& paths_;
  int tolerance_level_;
  int threads_;
  const EndSink& sink_;
  const std::atomic<bool>& stop_;
  Observations& observations_;
  Fingerprint list_;
  EndgameOptions options_;
  KeptEnds kept_;
  std::uint64_t known_ = 0;
  std::map<std::uint64_t, std::uint64_t> place_of_;  ///< of a path in the list
  std::vector<WaitingPath> waiting_;
  bool has_memory_ = true;
};

}  // namespace moivre
