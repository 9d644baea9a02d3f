// SPDX-License-Identifier: MIT
// How much longer does an output take one way than the other?
#pragma once

#include "moivre/design/readings.h"

namespace moivre {

/// Of those outputs of the reader that have one on this branch (design/readings.h).
std::vector<TimeRatio> time_ratios(const MotionResult& motion, const MotionBranch& branch,
                                   const Mechanism& mechanism, const QuantityReader& reader);

}  // namespace moivre
