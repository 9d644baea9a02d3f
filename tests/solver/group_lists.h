// SPDX-License-Identifier: MIT
// Groups of paths as lists that can be compared.
#pragma once

#include "path_groups.h"

namespace moivre::test {

using GroupLists = std::vector<std::vector<std::uint64_t>>;

inline GroupLists lists_of(const PathGroups& groups) {
  GroupLists lists;
  for (const PathGroups::Group group : groups) lists.emplace_back(group.begin(), group.end());
  return lists;
}

}  // namespace moivre::test
