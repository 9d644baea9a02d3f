// SPDX-License-Identifier: MIT
// How far does a tracker stray from the paths between Newton's corrections, and where does it leave them at t = 1?
//
// Paths of solve()'s homotopy, each followed the whole way, t: 0 -> 1, and watched at every step:
//
//   before   largest |H| of a step's point before Newton corrects it       |H| = max_i |H_i|, |x| = 1
//   after    largest |H| of the points that the tracker goes on from
//   end      where the last step left x: a method without correction has here the error that it has gathered
//
// Nothing is repaired and no endgame is run, so only paths to simple roots say something at t = 1.
// Watching costs evaluations: times are to be taken of solve(), not of this.
#pragma once

#include "moivre/solver/solve.h"

namespace moivre {

struct PathDrift {
  std::uint64_t path = 0;
  bool arrived = false;  ///< at t = 1, whichever root stands there
  double before = 0;
  double after = 0;
  double correction =
      0;      ///< largest first Newton correction of a step, relative to each coordinate
  Point end;  ///< in the system's variables; empty unless arrived
  StepCount count;
};

/// One entry a path, in the order of `paths`; paths that `stop` cut short have not arrived. Throws std::invalid_argument
/// when f is not square, has no paths to follow, or has fewer than a number in `paths` says.
std::vector<PathDrift> measure_drift(const System& f, const Tracker& tracker,
                                     const SolveOptions& options,
                                     const std::vector<std::uint64_t>& paths,
                                     const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
