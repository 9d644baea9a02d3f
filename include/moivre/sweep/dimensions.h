// SPDX-License-Identifier: MIT
// Which numbers of a mechanism may be varied, and by what names? Dimensions of bodies and joints, and what drivers prescribe.
//
//   body.point.x, .y, .z    coordinate of a point in its body's frame      length, in the file's unit
//   joint.length            of a rod                                      length
//   joint.turn              of a prismatic joint or a weld                angle
//   a driver's name         its value: the law is replaced by it          in the file's units
// Angles are in the file's unit, degrees where it says so.
// Not supported: constants of typed equations, axes, teeth.
#pragma once

#include <string>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// Every name that set_dimension() takes.
std::vector<std::string> dimension_names(const Mechanism& mechanism);

/// Throws std::invalid_argument where there is no such name.
void set_dimension(Mechanism& mechanism, const std::string& name, double value);

}  // namespace moivre
