// SPDX-License-Identifier: MIT
// How is a path followed that double loses? Every number of it in double-double: point, H, J, factors, step.
//
//   predict   the cubic through the last two points and tangents (Hermite); the tangent alone at first
//   correct   Newton's method, a fresh J each time, until it has converged far below the step's tolerance
//   step      from the first Newton correction, whose size is the predictor's error: h <- h (tolerance / |dx_1|)^{1/4}
//
// For the few paths that need it: some thirty times the time of a double's step. s is kept beside 1 - s, so that steps near
// either end may be as small as doubles are. At t = 1 it arrives only where Newton's method contracts, far
// better than a multiple root allows, until rounding stops it, with a condition that double-double can bear.
// A singular end is step_too_small. Departure::care divides the tolerance by 10 a level.
// Source: [Deuflhard04] for the step, [Timme21] for the norm.
#pragma once

#include <cstdint>
#include <memory>

#include "moivre/tracker/tracker.h"

namespace moivre {

struct DoubleDoubleOptions {
  double tolerance = 1e-5;             ///< |dx_1|_w that steps aim at
  std::int64_t maximum_steps = 20000;  ///< of one journey
};

std::unique_ptr<Tracker> make_double_double_tracker(const DoubleDoubleOptions& options = {});

}  // namespace moivre
