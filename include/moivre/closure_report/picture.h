// SPDX-License-Identifier: MIT
// How do all closures of a mechanism look, side by side to one scale? As one SVG document.
//
// A panel a closure with its id, the ground at the same place in each; title, counts, the drivers' values, a scale bar.
// Where there is no closure, the bodies stand as the initial guess puts them, faintly, and the picture says so.
// `file` is the name the user gave to the mechanism. Names are escaped: whatever they hold, the document stays well-formed.
#pragma once

#include <string>

#include "moivre/closure_report/drawing.h"
#include "moivre/closures/closures.h"

namespace moivre {

std::string closures_svg(const ClosureResult& result, const Mechanism& mechanism,
                         const std::string& file);

}  // namespace moivre
