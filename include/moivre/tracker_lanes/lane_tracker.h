// SPDX-License-Identifier: MIT
// How are many paths followed at once on one core? W of them in SIMD lanes, each with its own t and step.
//
//   W: 8 with AVX-512, 4 with AVX2, 2 with SSE4 and SSSE3; chosen when the program runs, so one build serves every machine
//   a step: quintic Hermite prediction, one evaluation of H, H_x, H_t, one factorization, two Newton updates, tangent
//
// A journey depends on its departure alone: not on its lane, its neighbours, or the number of threads. Two machines with
// different W follow the same paths, rounded differently.
// Edges: a lane in which something is not finite rejects its own step and touches no other.
// Not supported: targets without fixed-size vectors. Sources: [Timme21] for step control by contraction.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "moivre/tracker/tracker.h"

namespace moivre {

/// Local order of the lanes' predictor.
inline constexpr int kLaneOrder = 6;

struct LaneOptions {
  /// |dx|_w of the first Newton correction that steps aim at, in (0, 0.1].
  double tolerance = 3e-3;
  std::int64_t maximum_steps = 20000;  ///< accepted and rejected steps of one journey
};

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const LaneOptions& options);

/// Throws std::invalid_argument with all sentences of validate().
std::unique_ptr<Tracker> make_lane_tracker(const LaneOptions& options = {});

/// The instruction set in force, "AVX3" for example, and its W.
std::string lane_target();
std::size_t lane_width();

/// Every instruction set that was compiled and that this machine has, the best first.
std::vector<std::string> lane_targets();

}  // namespace moivre
