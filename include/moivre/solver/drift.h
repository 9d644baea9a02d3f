// SPDX-License-Identifier: MIT
// How far does a tracker stray from the paths between Newton's corrections, and where does it leave
// them at t = 1?
//
// Paths of solve()'s homotopy, each followed from t = 0 to t = 1 and measured at every step:
//
//   before   largest |H| of a step's point before Newton corrects it       |H| = max_i |H_i|, |x| =
//            1
//   after    largest |H| of the points from which the tracker continues
//   end      where the last step left x: a method without correction has its accumulated error here
//
// Nothing is tracked again and no endgame is run, so only paths to simple roots are meaningful at t
// = 1. Measuring costs evaluations: measure times with solve(), not with this.
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

/// One entry a path, in the order of `paths`; paths that `stop` cut short have not arrived. Throws
/// std::invalid_argument when f is not square, has no paths to follow, or has fewer than a number
/// in `paths` says.
std::vector<PathDrift> measure_drift(const System& f, const Tracker& tracker,
                                     const SolveOptions& options,
                                     const std::vector<std::uint64_t>& paths,
                                     const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
