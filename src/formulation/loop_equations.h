// SPDX-License-Identifier: MIT
// Which equations say that a product of turns and slides is a given pose? serial_loop.h has the mathematics.
#pragma once

#include "joint_loop.h"

namespace moivre {

/// How a loop is stated, begun where that is done best.
struct LoopForm {
  enum class Kind {
    slides,       ///< no turns: linear
    turns_first,  ///< three turns and three slides
    four_turns,   ///< and two slides (four_turns.h)
    short_loop,   ///< three to five elements
    decoupled,    ///< six, the last three stay in one 3-space
    general
  } kind = Kind::general;
  JointLoop loop;
};

/// For three to six elements, whatever their o and unknowns are.
LoopForm form_of(JointLoop loop, double length);
/// Whether slides follow linearly from the turns: they are to be unknowns themselves, o = 0.
bool has_linear_slides(LoopForm::Kind kind);

void add_loop_equations(SpatialFrame& frame, LoopForm form);

}  // namespace moivre
