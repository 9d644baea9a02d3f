// SPDX-License-Identifier: MIT
// What did the user mean? The known word nearest to one that is not known.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace moivre {

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The known word that differs least from `word`; nullopt when none is alike.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace moivre
