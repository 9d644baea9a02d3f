// SPDX-License-Identifier: MIT
// What can be chosen of the lanes? It stands apart from the tracker, so that every program knows
// its options by name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "moivre/tracker/option_table.h"

namespace moivre {

/// Hermite extrapolation through the last points and tangents of a path: how many of them.
enum class LanePredictor {
  tangent,  ///< one: Euler's, local order 2
  cubic,    ///< two: local order 4
  quintic   ///< three: local order 6
};

/// "tangent", "cubic", "quintic".
std::string to_string(LanePredictor predictor);
/// Local order.
int order_of(LanePredictor predictor);

struct LaneOptions {
  /// |dx|_w of the first Newton correction that steps aim at, in (0, 0.1].
  double tolerance = 3e-3;
  std::int64_t maximum_steps = 20000;  ///< accepted and rejected steps of one segment
  LanePredictor predictor = LanePredictor::quintic;
};

const OptionTable<LaneOptions>& lane_table();

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const LaneOptions& options);

}  // namespace moivre
