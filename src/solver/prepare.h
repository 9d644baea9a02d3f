// SPDX-License-Identifier: MIT
// How does the system as given become the homotopy that is tracked, and a point of it a point of
// the system again?
//
//   F (x, n unknowns) --eliminate--> R (y, k unknowns) --scale--> S (z)  ==>  a plan of homotopies
//   to S
//   Coordinates of a path: (z_1, ..., z_k, z_0);  y = 2^v z / z_0;  x = restore(y).
#pragma once

#include <optional>

#include "moivre/polynomial/eliminate.h"
#include "moivre/polynomial/scale.h"
#include "moivre/solver/given_start.h"
#include "moivre/solver/solve.h"
#include "moivre/start/start_plan.h"

namespace moivre {

struct Prepared {
  Reduction reduction;
  Scaling scaling;
  std::vector<LeftOut> left_out;
  double spread_log2 =
      0;  ///< log2 of the largest over the smallest coefficient of an equation of S
  std::optional<StartPlan>
      plan;  ///< nullopt when nothing is left to track, or the search for a start was interrupted
  StartFacts start;
  std::optional<MetBound> given_bound;  ///< of a given start
  bool leads_to_all = true;             ///< the plan leads to every isolated root
  bool leaves_out = false;              ///< but for some that are not wanted
  bool interrupted = false;
};

/// Throws as choose_start() does. A set `stop` ends the search for a start.
Prepared prepare(const System& f, const SolveOptions& options, const std::atomic<bool>& stop);

/// What a given start makes of f.
Prepared prepare_given(const System& f, GivenStart start);

/// Throws std::invalid_argument where elimination alone decides the system, so that there is no
/// path to follow.
void require_paths(const Prepared& prepared);

/// Every equation's largest coefficient in [1, 2), so that rows of F and G are of one size, and
/// none too small for double.
Scaling unit_rows(const System& f);

/// y and x of a homogeneous point with z_0 != 0.
Point to_reduced(const Prepared& prepared, const Point& homogeneous);
Point to_original(const Prepared& prepared, const Point& homogeneous);

/// Natural size of each original unknown: 2^v of a kept one, 1 of an eliminated one.
std::vector<double> natural_sizes(const Prepared& prepared);

}  // namespace moivre
