// SPDX-License-Identifier: MIT
// What is said of a system in every result, and which systems are refused before anything is done?
#pragma once

#include "moivre/solver/solve.h"

namespace moivre {

SystemFacts facts_of(const System& f);

/// Throws std::invalid_argument with the reason unless there are as many equations as unknowns.
void require_square(const System& f);

}  // namespace moivre
