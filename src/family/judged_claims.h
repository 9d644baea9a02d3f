// SPDX-License-Identifier: MIT
// Which claims of a family file count? Those that are found again here; the others are told as the
// file's.
//
// A checksum guards against accidents only: whoever changes a file can make it anew. So no number
// of the file proves another one.
//   bound      found again for a member that is drawn here, not for the file's: else it is dropped,
//              and proves no member
//   complete   refuted where exact algebra counts other roots of that member; else it stays what
//              the file says
// Roots need no judgement: from wrong ones paths lead nowhere, and each end is judged on its own
// member.
#pragma once

#include "moivre/family/family.h"

namespace moivre {

/// draw: of the member, a number that the file determines.
void judge_claims(Family& family, std::uint64_t draw);

}  // namespace moivre
