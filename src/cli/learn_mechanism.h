// SPDX-License-Identifier: MIT
// Which families does a mechanism consist of? One a kind of block of its closure equations, every
// coefficient a parameter.
#pragma once

#include <atomic>
#include <string>

#include "moivre/family/family_file.h"

namespace moivre {

/// Throws std::invalid_argument where the file is no mechanism, this program knows none, it has no
/// closures by solving, or the run was stopped.
FamilyFile learn_mechanism(const std::string& path, const Tracker& tracker,
                           const SolveOptions& options, const std::atomic<bool>& stop);

}  // namespace moivre
