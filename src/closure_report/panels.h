// SPDX-License-Identifier: MIT
// What do the sheets of all pictures share? Their scale.
#pragma once

#include "moivre/closure_report/drawing.h"

namespace moivre {

/// Pixels per unit of length, so that a joint has a radius of five.
double pixel_scale(const Drawing& drawing);

}  // namespace moivre
