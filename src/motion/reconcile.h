// SPDX-License-Identifier: MIT
// Do tracks and closures agree at every checkpoint, one to one? They are brought to agree, or the
// tracks stay unverified.
//
//   two tracks at one closure         the younger is a copy and goes, or both are followed again
//                                     with shorter steps
//   a closure without a track         a branch that begins since the last checkpoint: followed both
//                                     ways
//   a dead point that one track ends at     the branch that meets it there is followed from beyond
//                                           the fold
//   a way back that is not the way there    two tracks were exchanged for each other: followed
//                                           again with shorter steps
//
// Bounded: every track is followed again a few times only, and there are kRounds rounds a track.
// What does not agree in the end, the result says (motion_record.h).
#pragma once

#include "solved_checkpoint.h"

namespace moivre {

void reconcile(MotionRun& run, std::vector<SolvedCheckpoint>& checkpoints);

}  // namespace moivre
