// SPDX-License-Identifier: MIT
// How is a list said? Its parts one after another, with a separator between.
//
// Edges: no parts, no text; an empty part has its separators all the same.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moivre {

inline std::string joined(const std::vector<std::string>& parts, std::string_view separator) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (k > 0) text += separator;
    text += parts[k];
  }
  return text;
}

}  // namespace moivre
