// SPDX-License-Identifier: MIT
// How is a list of closures or branches told to a reader? "A, B, C"; of many the first ones, and
// how many there are.
#pragma once

#include <string>
#include <vector>

#include "moivre/expression/joined.h"

namespace moivre {

inline std::string id_list(std::vector<std::string> ids) {
  constexpr std::size_t kListed = 26;  // A to Z
  const std::size_t count = ids.size();
  if (count > kListed) {
    ids.resize(kListed);
    ids.push_back("... (" + std::to_string(count) + ")");
  }
  return joined(ids, ", ");
}

}  // namespace moivre
