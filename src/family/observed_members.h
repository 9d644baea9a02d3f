// SPDX-License-Identifier: MIT
// Which members were solved before? Their roots are taken as they were observed, and only the
// others are solved, block by block.
//
// Private to the module.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "moivre/family/members.h"
#include "moivre/homotopy/homotopy.h"

namespace moivre {

/// What members' roots depend on besides the members.
struct MembersTask {
  const Family& family;
  const Homotopy& homotopy;
  const Tracker& tracker;
  const SolveOptions& options;
  bool is_judged = false;  ///< members in doubt are
};

/// Solves members, as its options say; called with some of them at a time.
using MembersSolver =
    std::function<std::vector<MemberRoots>(std::span<const Point>, const SolveOptions&)>;

/// By options.observations, of all members; those of a block that `stop` cut short are not kept.
std::vector<MemberRoots> observe_members(const MembersTask& task, std::span<const Point> members,
                                         const MembersSolver& solve, const std::atomic<bool>& stop);

/// The exact bytes of a member's roots, and these again. Throws std::invalid_argument where they
/// are none.
std::string bytes_of(const MemberRoots& roots);
MemberRoots member_roots_of(std::string_view bytes);

}  // namespace moivre
