// SPDX-License-Identifier: MIT
// How are counts of a sweep told to people, beside the number of real closures?
#pragma once

#include <string>

#include "moivre/sweep/sweep.h"

namespace moivre {

/// ", 1 outside a joint's limits, 2 within fit, and it moves though the drivers stand"; empty where
/// there is nothing of it.
std::string beside_text(const Assemblies& found);

}  // namespace moivre
