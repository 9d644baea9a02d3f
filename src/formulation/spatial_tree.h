// SPDX-License-Identifier: MIT
// Which polynomials close a part of a spatial mechanism, whatever its loops? A tree of hinges, and
// the ties that are left.
//
// From the ground outwards the stiffest tie places the next group (revolute and prismatic joints
// before cylindrical ones and cones, these before spherical joints); a group on rods alone has any
// pose. Every tie that placed nothing is an equation on the relative pose of its groups, taken from
// where their branches of the tree part.
// A rod is |4 g g - L^2 q q|, of degree 2 in every unknown; of several rods between two groups the
// first is subtracted from the others, so that one of them alone has the highest terms: a platform
// on six legs has 84 paths instead of 128 [WamplerSoma96].
#pragma once

#include <cstddef>
#include <vector>

#include "spatial_frame.h"

namespace moivre {

/// Groups that are tied to each other without passing the ground, and all their ties.
struct Part {
  std::vector<std::size_t> groups;
  std::vector<std::size_t> ties;
};

void add_tree(SpatialFrame& frame, const RigidGroups& groups, const Part& part);

}  // namespace moivre
