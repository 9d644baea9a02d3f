// SPDX-License-Identifier: MIT
// What do the library's words for its options and functions mean on the command line?
#pragma once

#include <string>

namespace moivre {

/// A refusal of the library, which names its own options in backquotes, in the words of the command
/// line.
std::string in_option_words(std::string refusal);

}  // namespace moivre
