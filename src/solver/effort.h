// SPDX-License-Identifier: MIT
// How far are paths followed before it is asked whether the others are all that can be?
//
// Where the roots that are proved meet a bound, paths without an end lead to no other root
// (completeness.h). Most of these are paths to infinity, whose ends take ten times as long to find
// as the way there. So effort rises from one asking to the next.
//
// Private to the module.
#pragma once

#include "setting.h"

namespace moivre {

enum class Effort {
  regular_ends,  ///< to ends that are proved; no circle is tried
  few_steps,     ///< to any end, with a share of the steps near t = 1
  all_steps
};

/// With which all paths of the plan are followed.
Effort first_effort(const Setting& setting);

/// How ends are sought with that effort.
EndgameOptions endgame_for(const Setting& setting, Effort effort);

}  // namespace moivre
