// SPDX-License-Identifier: MIT
// What may bodies, points, joints and unknowns be called?
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace moivre {

inline constexpr const char* kNameRule = "names have letters, digits, '_' and '-' only";

/// Letters, digits, '_' and '-', not empty.
inline bool is_name(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  });
}

}  // namespace moivre
