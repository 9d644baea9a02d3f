// SPDX-License-Identifier: MIT
// Groups of paths as lists that can be compared.
#pragma once

#include "judged_roots.h"

namespace moivre::test {

using GroupLists = std::vector<std::vector<std::uint64_t>>;

inline GroupLists lists_of(const PathGroups& groups) {
  GroupLists lists;
  for (const PathGroups::Group group : groups) lists.emplace_back(group.begin(), group.end());
  return lists;
}

inline GroupLists lists_of(const JudgedRoots& roots) {
  GroupLists lists;
  for (const auto& [group, ground] : roots) lists.emplace_back(group.begin(), group.end());
  return lists;
}

}  // namespace moivre::test
