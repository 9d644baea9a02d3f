// SPDX-License-Identifier: MIT
// Which roots of many members are proved to be roots of the exact systems, and different ones?
// Members with others are not complete.
//
// Private to the module.
#pragma once

#include "moivre/family/members.h"

namespace moivre {

/// Sets MemberRoot::certified of members that are complete; one with a root that has no proof is
/// not complete any more.
void certify_members(const Family& family, std::span<const Point> members, int threads,
                     const std::atomic<bool>& stop, std::vector<MemberRoots>& results);

/// How many of the family's roots are proved to be roots at p*, no two of them one.
std::size_t certified_roots(const Family& family, int threads, const std::atomic<bool>& stop);

}  // namespace moivre
