// SPDX-License-Identifier: MIT
// How are many paths followed at once on one core? W of them in SIMD lanes, each with its own t and
// step.
//
//   W: 8 with AVX-512, 4 with AVX2, 2 with SSE4 and SSSE3; chosen when the program runs, so one
//   build serves every machine in_double_double(): the same lanes with two doubles for each number,
//   for paths that double cannot decide a step: Hermite prediction, one evaluation of H, H_x, H_t,
//   one factorization, two Newton updates, tangent
//
// The result of a segment depends on the segment alone, not on its lane, its neighbours, or the
// number of threads. Two machines with different W follow the same paths, rounded differently.
// Edges: a lane in which something is not finite rejects its own step and touches no other.
// Not supported: targets without fixed-size vectors. Sources: [Timme21] for step control by
// contraction.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "moivre/tracker/tracker.h"
#include "moivre/tracker/tracker_options.h"

namespace moivre {

/// The largest tolerance in double-double, so that paths do not jump there.
inline constexpr double kFineLaneTolerance = 1e-5;

/// Throws std::invalid_argument with all sentences of validate().
std::unique_ptr<Tracker> make_lane_tracker(const LaneOptions& options = {});

/// The instruction set in force, "AVX3" for example, and its W.
std::string lane_target();
std::size_t lane_width();

/// Every instruction set that was compiled and that this machine has, the best first.
std::vector<std::string> lane_targets();

}  // namespace moivre
