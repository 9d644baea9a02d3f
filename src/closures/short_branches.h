// SPDX-License-Identifier: MIT
// Do branches begin and end between two scenes, and meet no other? They are sought where complex closures come near to real.
//
// In three scenes running, every pair of complex closures is looked up again; where the parabola through its squared distances
// from real dips well below them (near_real.h), closures are solved at the vertex, which takes the place of the farthest of the
// three, until pairs have become real there, or the distance is seen to turn.
// Not seen: a stretch of real closures beside which the distance is no parabola over three scenes.
#pragma once

#include "scene.h"

namespace moivre {

struct ShortBranches {
  std::vector<Scene> solved;     ///< for the search
  std::vector<double> instants;  ///< times at which complex closures meet, are real, and part again
};

/// Adds the tracks to the run.
ShortBranches follow_short_branches(MotionRun& run, const Tracker& tracker,
                                    const std::vector<Scene>& scenes);

}  // namespace moivre
