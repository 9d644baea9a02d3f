// SPDX-License-Identifier: MIT
// How do all closures of a mechanism look, and what curves do its points describe? As SVG
// documents.
//
// closures  one panel per closure with its id, all to one scale, the ground at the same place in
//           each; title, counts, the drivers' values, a scale bar. Where there is no closure, the
//           bodies are drawn at the initial guess, with a note.
// motion    the curves of points over the mechanism's first pose, one colour per branch, where
//           branches begin and end, a legend.
//           The points: those without a joint, else those of bodies that no joint holds to the
//           ground.
// `file` is the name the user gave to the mechanism. Names are escaped: whatever they hold, the
// document stays well-formed.
#pragma once

#include <string>

#include "moivre/closure_report/sheet.h"
#include "moivre/motion/motion.h"

namespace moivre {

/// Throws std::invalid_argument where three views are asked for of what lies in a plane.
std::string closures_svg(const ClosureResult& result, const Mechanism& mechanism,
                         const std::string& file, Views views = Views::standing);

/// Curves of points; for typed equations, which have none, each unknown over the time.
std::string motion_svg(const MotionResult& result, const Mechanism& mechanism,
                       const std::string& file);

}  // namespace moivre
