// SPDX-License-Identifier: MIT
// What do the reports for people share? Degrees, counts that may be too large, and the list of what
// was left out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "moivre/solver/solve.h"

namespace moivre {

/// "2 2 3", or with repetitions counted when the list is long: "2 (8 times) 1".
std::string degrees_text(const std::vector<std::uint64_t>& degrees);

/// The number, or that it is beyond 64 bits.
std::string count_text(const std::optional<std::uint64_t>& count);

/// "re + im i" with six digits, the imaginary part only where there is one.
std::string complex_text(Complex x);

/// A paragraph with a heading, an item a line; empty when nothing was left out.
std::string left_out_text(const std::vector<LeftOut>& left_out);

}  // namespace moivre
