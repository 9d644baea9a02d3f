// SPDX-License-Identifier: MIT
// Which angles follow from the drivers through gears, whole turns counted? A wheel of 53 teeth meshes in 53 ways; one was drawn.
//
//   driver      a_j - a_i = f(t)                          whole turns included
//   weld, prismatic   a_j - a_i = turn
//   gear        z_i (a_i - a_c) = z_j (a_j - a_c - phase)  as numbers, not modulo a turn
// Linear equations; a body whose angle they determine has that angle, and a gear all of whose bodies have theirs holds.
// Symbols: a_i angle of body i (rad, whole turns counted), the ground's is 0; z teeth.
// Edges: a contradiction determines nothing, then the gears stand as they are, in every meshing.
#pragma once

#include <optional>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// Of each body, rad; nothing for a body whose angle depends on more than drivers, welds, guides and gears.
std::vector<std::optional<double>> driven_angles(const Mechanism& mechanism, double t);

/// Whether the gear is to hold in the drawn meshing alone, and does by these angles.
bool is_settled(const Joint& gear, const std::vector<std::optional<double>>& angles);

}  // namespace moivre
