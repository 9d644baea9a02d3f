// SPDX-License-Identifier: MIT
// How is a path followed that double cannot decide? Entirely in double-double: point, H, J, factors, step.
//
//   predict   the cubic through the last two points and tangents (Hermite); the tangent alone at first
//   correct   Newton's method, a fresh J each time, until it has converged far below the step's tolerance
//   step      from the first Newton correction, whose size is the predictor's error: h <- h (tolerance / |dx_1|)^{1/4}
//
// For the few paths that need it: a step takes some thirty times as long as in double. s and 1 - s are both stored, so that steps
// near either end may be as small as doubles are. A path reaches t = 1 only at a regular end: Newton's method must contract far
// better than at a multiple root until rounding stops it, and the condition must not be too large for double-double. At a
// singular end the result is step_too_small. Each level of Departure::care divides the tolerance by 10.
// Source: [Deuflhard04] for the step, [Timme21] for the norm.
#pragma once

#include <cstdint>
#include <memory>

#include "moivre/tracker/tracker.h"

namespace moivre {

struct DoubleDoubleOptions {
  double tolerance = 1e-5;             ///< |dx_1|_w that steps aim at
  std::int64_t maximum_steps = 20000;  ///< of one segment
};

std::unique_ptr<Tracker> make_double_double_tracker(const DoubleDoubleOptions& options = {});

}  // namespace moivre
