// SPDX-License-Identifier: MIT
// What is meant by what no expression has: characters that are printed but not typed, and signs of
// other languages (≤, √2, // comment, x_{1})?
//
// Edges: `-`, `*` and the like that texts are copied with are among them; Greek letters and small
// digits below the line are none, for names have them.
#pragma once

#include <string>
#include <string_view>

namespace moivre {

/// "; type `<=` for it", for what text[at] begins or ends; empty where nothing is known to be
/// meant.
std::string lookalike_advice(std::string_view text, std::size_t at);

/// The text with what is typed in the place of what is meant, to be judged, not to be read: `#`
/// where a comment begins, and `!=`.
std::string with_what_is_meant(std::string_view text);

}  // namespace moivre
