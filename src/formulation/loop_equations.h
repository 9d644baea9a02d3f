// SPDX-License-Identifier: MIT
// Which equations say that a product of turns and slides is a given pose? serial_loop.h has the mathematics.
#pragma once

#include "loop.h"

namespace moivre {

/// The pose within rounding, by short numbers.
ExactPose shortened(const ExactPose& pose);
/// A of a turn about the z axis of a frame, and of a slide along it.
ExactPose axis_at(const ExactPose& frame);
ExactPose slide_at(const ExactPose& frame);

/// Whether the loop's slides are to be unknowns themselves (o = 0), since they are found linearly behind the turns. For three to six
/// elements, whatever their o is now.
bool takes_plain_slides(const Loop& loop, double length);

/// For three to six elements.
void add_loop_equations(SpatialFrame& frame, const Loop& loop);

}  // namespace moivre
