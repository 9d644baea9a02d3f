// SPDX-License-Identifier: MIT
// What is a body on six rods in general, and what are its poses? A start with as many paths as
// there are poses: 40.
//
//   F_k   the equation of rod k: in the span of 17 quadratic forms in Study's coordinates (q, g),
//         whatever its points and length
//   G     the equations of six rods in general position, the patch and Study's quadric as F has
//         them; 40 poses, no real one
//   t F + (1 - t) c G, c on the unit circle: every equation stays in its span
//
// Bodies on six rods have 40 poses in general [RongaVust95], and so have six general equations of
// the span with Study's quadric (a test solves such). So the 40 paths from the poses of G lead to
// every isolated pose of any body on six rods.
// Roots with |q|^2 = 0 are no poses. They are not sought; the formulation excludes those that a
// path reaches.
#pragma once

#include "moivre/formulation/formulation.h"
#include "spatial_tree.h"

namespace moivre {

/// `part`: one group, its first six ties rods to the ground, stated in a frame of this length
/// before anything else is. Polynomials and unknowns stand in the order of add_tree().
Formulation::GeneralMember general_six_rods(RigidGroups groups, Part part, double length);

}  // namespace moivre
