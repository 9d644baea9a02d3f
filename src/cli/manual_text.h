// SPDX-License-Identifier: MIT
// What does a man page say that --help does not? What a command is for, and what its answer is
// worth.
#pragma once

#include <string>
#include <vector>

namespace moivre {

/// Paragraphs on the command of this name ("solve", "family learn"; "" is `moivre` itself); empty
/// where there is none.
std::vector<std::string> paragraphs_on(const std::string& command);

/// Pages that belong together: what to read besides this one.
std::vector<std::string> related_to(const std::string& command);

}  // namespace moivre
