// SPDX-License-Identifier: MIT
// From where do paths lead to a member of a family? From the roots at p*.
#pragma once

#include "moivre/family/family.h"
#include "moivre/solver/given_start.h"

namespace moivre {

/// The start that the family gives to `member`, its system at p.
GivenStart start_of_member(const Family& family, const ParameterValues& p, const System& member);

}  // namespace moivre
