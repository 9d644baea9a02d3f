// SPDX-License-Identifier: MIT
// What did the typist mean? The known word nearest to a misspelt one, as the end of a message.
#pragma once

#include <string>
#include <vector>

namespace moivre {

/// "; did you mean 'crank'?" where a known word is near, else "; known are 'a', 'b'" (a few of them), else "".
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

}  // namespace moivre
