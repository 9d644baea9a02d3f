// SPDX-License-Identifier: MIT
// What is closure number k called? A to Z, then AA, AB, ...; of a sub-chain with the sub-chain's
// number.
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

/// The name of the closure that was drawn, beside its id.
inline constexpr const char* kDrawn = "drawn";

/// Of the k-th of several sub-chains, which each have a closure E: 1:E, 2:E.
inline std::string sub_chain_name(std::size_t k, const std::string& id) {
  return std::to_string(k + 1) + ':' + id;
}

}  // namespace moivre
