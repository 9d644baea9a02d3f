// SPDX-License-Identifier: MIT
// What did the typist mean? The known word nearest to a misspelt one, alone and as the end of a
// message.
//
// Near: no more than a third of the letters, rounded, are inserted, left out, replaced or swapped
// with the next one. Capitals count as small letters, and "-ies" as "-y". A word of one letter is
// near itself only, one of more than 64 letters near none.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace moivre {

/// The first of the nearest ones; nothing where none is near.
std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& known);

/// "; did you mean 'crank'?" where a known word is near, else "; known are 'a', 'b'" (a few of
/// them), else "".
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

}  // namespace moivre
