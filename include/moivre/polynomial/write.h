// SPDX-License-Identifier: MIT
// How is a system written down again? In PHCpack's and Bertini's text. Reading it back gives the
// same System:
// coefficients are written exactly, as they were typed, and so that the variables come in their
// order. Groups stand in Bertini's text alone.
#pragma once

#include <string>

#include "moivre/polynomial/read.h"

namespace moivre {

/// Throws std::invalid_argument when there is nothing to write, a variable's name has a meaning of
/// its own in the format, or (Bertini) the variables do not come group by group.
std::string to_text(const System& f, PolynomialFormat format);

}  // namespace moivre
