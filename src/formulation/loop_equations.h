// SPDX-License-Identifier: MIT
// Which equations say that a product of turns and slides is a given pose? serial_loop.h has the mathematics.
#pragma once

#include <string>
#include <vector>

#include "spatial_frame.h"

namespace moivre {

/// One joint of one freedom: E = b0 + unknown b1, with b0 = 1 + o A, b1 = A - o for a turn; b0 = 1, b1 = A - o for a slide.
struct LoopElement {
  ExactPose axis;      ///< A
  Rational fixed = 0;  ///< o
  bool is_turn = false;
  std::string name;
  Polynomial unknown;
  std::vector<std::string> owners;
};

/// The pose within rounding, by short numbers.
ExactPose shortened(const ExactPose& pose);
/// A of a turn about the z axis of a frame, and of a slide along it.
ExactPose axis_at(const ExactPose& frame);
ExactPose slide_at(const ExactPose& frame);

/// E_1 E_2 ... ~ whole, for three to six elements.
void add_loop_equations(SpatialFrame& frame, std::vector<LoopElement> elements,
                        const ExactPose& whole);

}  // namespace moivre
