// SPDX-License-Identifier: MIT
// Which of these numbers are not finite and above 0? A broken rule for each, as options tell them.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace moivre {

/// "<name> must be finite and above 0", in the order of the numbers; empty where all are.
std::vector<std::string> not_positive(
    std::initializer_list<std::pair<const char*, double>> numbers);

}  // namespace moivre
