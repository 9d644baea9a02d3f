// SPDX-License-Identifier: MIT
// Which unknowns does each part of a spatial mechanism get? A rule by its structure.
//
//   one loop of six freedoms       half angles of four joints (serial_loop.h): 24 paths for any six
//                                  axes, 4 + 4 x 2 where three of them are parallel or meet
//   one loop of three to five      likewise, overdetermined unless the loop is spherical or planar
//   everything else                bodies hinged to one another by half angles and slides, a body
//                                  on rods alone by Study's eight coordinates (spatial_tree.h)
// Parts that share nothing but the ground are stated one by one.
#pragma once

#include "moivre/formulation/formulation.h"

namespace moivre {

Formulation spatial_bodies(const Mechanism& mechanism, double t);

}  // namespace moivre
