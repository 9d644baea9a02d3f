// SPDX-License-Identifier: MIT
// Where the module certify is not built nothing is proved of many members.
#include "certified_members.h"

namespace moivre {

void certify_members(const Family&, std::span<const Point>, int, const std::atomic<bool>&,
                     std::vector<MemberRoots>&) {}

std::size_t certified_roots(const Family&, int, const std::atomic<bool>&) { return 0; }

}  // namespace moivre
