// SPDX-License-Identifier: MIT
// How is a system written down again? In PHCpack's and Bertini's text.
// Reading it back gives the same System.
#pragma once

#include <string>

#include "moivre/polynomial/read.h"

namespace moivre {

std::string to_text(const System& f, PolynomialFormat format);

}  // namespace moivre
