// SPDX-License-Identifier: MIT
// Which family does moivre family learn write? That of a polynomial file and its parameters.
#pragma once

#include "command.h"
#include "common_options.h"

namespace moivre {

void add_family_learn(CLI::App& family, Chosen& chosen);

}  // namespace moivre
