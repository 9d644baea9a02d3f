// SPDX-License-Identifier: MIT
// Which members does moivre family solve solve? One typed, or the rows of a table.
#pragma once

#include "command.h"
#include "common_options.h"

namespace moivre {

void add_family_solve(CLI::App& family, Chosen& chosen);

}  // namespace moivre
