// SPDX-License-Identifier: MIT
// What is done with a checkpoint at which branches cross, where closures are not all decided?
//
// Where branches cross, the pose may move though the drivers stand (an arm's straight wrist). Paths come to no isolated root there.
// The fine times on both sides take the checkpoint's place: what is one to one there is so across the crossing, too.
// Edges: a crossing at the first or at the last checkpoint has one side only and stays.
#pragma once

#include "scene.h"

namespace moivre {

/// The times of the checkpoints that were replaced.
std::vector<double> step_aside(const MotionRun& run, const Tracker& tracker,
                               std::vector<Scene>& scenes);

}  // namespace moivre
