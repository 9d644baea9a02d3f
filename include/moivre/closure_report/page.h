// SPDX-License-Identifier: MIT
// How can closures be seen and driven in a browser? One self-contained page: drawings, a slider,
// plots with units on their axes.
//
// One panel per branch with its closure, driven by one slider through the samples; position,
// velocity and acceleration of a quantity of choice over time, one line per branch. Plain inline
// script and style, nothing from the network (its content policy forbids it); without a script the
// page shows the first poses. Names are escaped in markup and in the page's data.
// With `readings` a designer's quantities can be plotted too. A branch is hidden by a click on its
// name in the legend, enlarged by a click on its panel's name; a button saves all plotted
// quantities as CSV, angles in the file's unit. Another saves the panels that are shown as one
// animated SVG (SMIL, no script), which plays wherever a picture is shown.
// In the address, #t=1.5 sets the time and #plot=2 the plotted quantity (in the order of the list).
#pragma once

#include <string>

#include "moivre/motion/motion.h"

namespace moivre {

struct Readings;

std::string motion_html(const MotionResult& result, const Mechanism& mechanism,
                        const std::string& file, const Readings* readings = nullptr);

/// Closures without motion: no slider, no plots.
std::string closures_html(const ClosureResult& result, const Mechanism& mechanism,
                          const std::string& file);

}  // namespace moivre
