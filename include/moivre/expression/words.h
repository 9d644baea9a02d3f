// SPDX-License-Identifier: MIT
// What does a line of text hold between its blanks? The text without them, the number that a word
// is, and the sign between the sides of an equation.
//
// Edges: text that is blank throughout is trimmed to the empty text at its end, so that positions
// in a file stay true. A word is a number only as a whole; a plus sign may stand before it, "inf"
// and "nan" are numbers, one beyond double is none.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace moivre {

inline constexpr std::string_view kBlanks = " \t\n\v\f\r";

/// `text` without the blanks at its ends.
inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

/// `=` or, as some programs write it, `==`; length 0 where there is none.
struct EqualsSign {
  std::size_t at = 0;
  std::size_t length = 0;
};

/// The first one.
inline EqualsSign equals_sign(std::string_view text) {
  const std::size_t at = text.find('=');
  if (at == std::string_view::npos) return {};
  return {at, text.substr(at).starts_with("==") ? std::size_t{2} : std::size_t{1}};
}

inline std::optional<double> to_number(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double x = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), x);
  if (read.ec != std::errc() || read.ptr != word.data() + word.size()) return std::nullopt;
  return x;
}

}  // namespace moivre
