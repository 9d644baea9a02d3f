// SPDX-License-Identifier: MIT
// What does accuracy cost for a mechanism? All its closures, with every setting, and its motion
// against differences.
//
// Closures: as study/study.h, of find_closures() at time 0. Errors are those of the places p = x +
// iy and directions e^{i phi} of formulation/formulation.h, complex closures included; each closure
// counts, real or not.
// Motion: the first real closure over natural_duration() (closure_study/motion_table.h), as the
// result's table; its row with N samples is one point of each curve of the diagram.
#pragma once

#include "moivre/mechanism/mechanism.h"
#include "moivre/study/study.h"

namespace moivre {

/// As study_system(). Throws std::invalid_argument where the mechanism is not supported.
StudyResult study_mechanism(const Mechanism& mechanism, const std::vector<StudySetting>& settings,
                            const Tracker& reference_tracker, const Tracker* witness,
                            const StudyOptions& options = {},
                            const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
