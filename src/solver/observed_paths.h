// SPDX-License-Identifier: MIT
// Which paths of a list were followed before? Their ends are taken as they were observed; only the
// others are followed.
//
// Ends that no other path has a part in are kept as they come. Where paths wait for one another
// (path_pool.h), those that have waited do so again until all of the list have ended: then what
// each sees is what it saw. An end that a stop cut short was not observed.
#pragma once

#include "moivre/endgame/endgame.h"
#include "moivre/numeric/observations.h"
#include "path_pool.h"

namespace moivre {

/// track_paths(), with the other processes where there are any, and by what `observations` has,
/// where there are any; it takes the other ends.
bool observe_paths(const PathProblem& problem, const PathList& paths, int tolerance_level,
                   int threads, const EndSink& sink, const std::atomic<bool>& stop,
                   Observations* observations);

/// The homotopy, tracker, endgame and paths of a list, and the outcomes of a list that depend on
/// the same.
Fingerprint list_of(const PathProblem& problem, const PathList& paths, int tolerance_level);

/// The exact bytes of an end, and the end again. Throws std::invalid_argument where these are no
/// end's.
std::string bytes_of(const PathEnd& end);
PathEnd end_of(std::string_view bytes);

/// Whose part there is in what became of a path.
enum class EndPart { of_itself, of_others_too };

/// Ends of a list on their way to be kept: those in which other paths have a part all together,
/// when all have ended.
class KeptEnds {
 public:
  KeptEnds(const PathProblem& problem, Observations& observations, const Fingerprint& list);
  void take(std::uint64_t path, const PathEnd& end, EndPart part);
  void keep_circles();
  std::uint64_t ended() const { return ended_; }

 private:
  Observations& observations_;
  Fingerprint list_;
  bool may_wait_ = false;
  std::uint64_t ended_ = 0;
  std::vector<JobOutcome> of_circles_ = {};
};

}  // namespace moivre
