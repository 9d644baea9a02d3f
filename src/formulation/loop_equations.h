// SPDX-License-Identifier: MIT
// Which equations say that a product of turns and slides is a given pose? serial_loop.h has the
// mathematics.
#pragma once

#include "joint_loop.h"

namespace moivre {

/// How a loop is stated.
struct LoopForm {
  JointLoop loop;  ///< begun where that is done best
  /// Slides follow linearly from the turns, and are to be unknowns themselves, o = 0.
  bool has_linear_slides;
  void (*add_equations)(SpatialFrame& frame, const JointLoop& loop);
};

/// By how much turns about no more than two directions fail to make up the loop's own, whatever
/// their angles; 0 where there are more. Parallel axes are one direction, whatever slides are
/// between them.
double turn_not_made_up(const JointLoop& loop);

/// For three to six elements, whatever their o and unknowns are.
LoopForm form_of(const JointLoop& loop, double length);

}  // namespace moivre
