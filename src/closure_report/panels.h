// SPDX-License-Identifier: MIT
// What do the sheets of all pictures share? Their scale, and how drivers are told.
#pragma once

#include <string>

#include "moivre/closure_report/drawing.h"

namespace moivre {

/// Whether it prescribes an angle, or a length.
bool drives_angle(const Mechanism& mechanism, const Driver& driver);

/// "crank = 40 deg, guide = 12 mm": the drivers at this time; empty without drivers.
std::string drivers_text(const Mechanism& mechanism, double time);

/// Pixels per unit of length, so that a joint has a radius of five.
double pixel_scale(const Drawing& drawing);

}  // namespace moivre
