// SPDX-License-Identifier: MIT
// What is closure number k called? A to Z, then AA, AB, ...
#pragma once

#include <cstddef>
#include <string>

namespace moivre {

/// 0 -> A, 25 -> Z, 26 -> AA.
inline std::string closure_id(std::size_t index) {
  constexpr std::size_t kLetters = 26;
  std::string text;
  for (std::size_t k = index + 1; k > 0; k = (k - 1) / kLetters) {
    text.insert(text.begin(), static_cast<char>('A' + (k - 1) % kLetters));
  }
  return text;
}

}  // namespace moivre
