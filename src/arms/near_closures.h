// SPDX-License-Identifier: MIT
// Where on a set that is there within the digits only does the arm close exactly?
//
//   miss(s) = u . error at the place s of the set, u the direction in which the tip can least move,
//   turned little from place to place
// It changes its sign at a closure; it touches 0 where two closures meet. Both are found by secants
// of second order along the set: Newton's method alone leaves a set that is curved. Where it is
// rounding for a while there is one place. Edges: closures nearer to each other than two samples
// are may be missed.
// Source: Muller's method [Muller56]. Private to the module.
#pragma once

#include <vector>

#include "set_place.h"

namespace moivre {

/// Places near closures. places: samples of a curve, in order; of one that closes with the first
/// two again at the end.
std::vector<Eigen::VectorXd> near_closures(const Arm& arm, const Eigen::Isometry3d& pose,
                                           const SetPlaces& places, double accuracy);

}  // namespace moivre
