// SPDX-License-Identifier: MIT
// What does a solve work on, and with which trackers? All that stays the same from its first path
// to its last.
//
//   first       the tracker that solve() was given: every path, in double
//   fallback    SolveOptions::fallback, where there is one: what `first` left in doubt
//   fine_lanes  one of both in double-double, several paths at once; nullptr where neither has that
//   fine        double-double, one path at a time; nullptr where no path is to be followed beyond
//               double
//   finer       more digits, one path at a time; none where roots are not proved, since double
//               tells no other root of these
//
// Edges: where the elimination decided the system, prepared.plan is nullopt and there are no paths.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "path_pool.h"
#include "prepare.h"
#include "refine.h"

namespace moivre {

class CertifyProgram;

struct Trackers {
  const Tracker& first;
  const Tracker* fallback;
  std::unique_ptr<Tracker> fine_lanes;
  std::unique_ptr<Tracker> fine;
  std::vector<std::unique_ptr<Tracker>> finer;
};

struct Setting {
  /// Prepares the system. Throws std::overflow_error when the number of paths leaves 64 bits.
  Setting(const System& f, const Tracker& tracker, const SolveOptions& options,
          const std::atomic<bool>& stop);
  /// The system is prepared already.
  Setting(const System& f, Prepared prepared, const Tracker& tracker, const SolveOptions& options,
          const std::atomic<bool>& stop);

  const System& f;
  const SolveOptions& options;
  const std::atomic<bool>& stop;
  const int threads;
  const Trackers trackers;
  const Prepared prepared;
  EndgameOptions endgame;
  const std::shared_ptr<const RefinerProgram> refiner_program;
  const std::shared_ptr<const CertifyProgram> certify_program;  ///< nullptr: f has no unknowns

  /// Every path in double-double from the start.
  bool is_fine() const { return options.precision == Precision::double_double; }
  /// Terms that no path of that precision tells: only a simple root, proved on the system as given,
  /// says something about the system.
  bool hides_terms(PathPrecision precision) const;
  /// Who follows all paths at first.
  const Tracker& tracker() const;
  bool falls_back(int tolerance_level) const;
  /// All paths, by who follows them at that tolerance level.
  PathProblem problem(int tolerance_level) const;
};

}  // namespace moivre
