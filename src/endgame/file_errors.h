// SPDX-License-Identifier: MIT
// What may the errors of the file's numbers change in the samples of a circle? To first order, each
// number's own.
//
//   H(x, t) = 0, a x = 1:   dx_0 / dc = -l J^{-1} [H_c ; 0],   l = e_0 - x_0 a       J = [H_x ;
//                           x^H]
//
// A number's change moves the ends of the paths and the samples together. The power sums of x_0
// that vanish within what all numbers may change in them vanish for some system that the file may
// mean. On the circle J is regular, whatever it is at the end.
// x: samples, homogeneous, in `frame` (nullptr: none), on the patch a. Edges: samples at which J is
// singular change by nothing.
// Private to the module.
#pragma once

#include <vector>

#include "moivre/tracker/contour.h"
#include "moivre/tracker/path_system.h"

namespace moivre {

/// Of each number, in each sample: what half a unit of its last digit changes in x_0. `samples`:
/// turns over the circle one after the other, `of_turn` each.
std::vector<std::vector<Complex>> changes_of_x0(PathSystem& path, const PathFrame* frame,
                                                const Contour& circle, std::size_t of_turn,
                                                const std::vector<Point>& samples,
                                                const Point& patch);

}  // namespace moivre
