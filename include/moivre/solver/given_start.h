// SPDX-License-Identifier: MIT
// How is a system solved from a start that is known already? As by solve(), but for the search for
// a start.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "moivre/polynomial/eliminate.h"
#include "moivre/polynomial/scale.h"
#include "moivre/solver/solve.h"
#include "moivre/start/start_plan.h"

namespace moivre {

/// A start that the caller has made, from a family's roots for example.
struct GivenStart {
  StartPlan plan;  ///< to scale(f, scaling), but for the rows' sizes; its points are in those units
  Scaling scaling;                          ///< of f, or of reduction.system
  std::optional<Reduction> reduction = {};  ///< of f, where the plan leads to its system; square
  std::string why;                          ///< where the start comes from
  std::optional<MetBound> bound = {};       ///< proved: f has no more isolated roots than that
  /// A path leads to every isolated root; if not, and no count tells, the result is not complete.
  bool is_complete = true;
  bool leaves_out = false;  ///< roots that are not wanted: exact algebra would count them
};

/// As solve(), by that start. f: square, without homogeneous groups.
SolveResult solve_from(const System& f, GivenStart start, const Tracker& tracker,
                       const SolveOptions& options = {},
                       const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
