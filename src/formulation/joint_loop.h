// SPDX-License-Identifier: MIT
// What is a loop of joints of one freedom? A product of turns and slides that is a given pose,
// wherever it begins and whichever way round it is read.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "spatial_frame.h"

namespace moivre {

/// One joint of one freedom: E = b0 + unknown b1, with b0 = 1 + o A, b1 = A - o for a turn; b0 = 1,
/// b1 = A - o for a slide.
struct LoopElement {
  std::size_t number = 0;  ///< in the loop as it is followed
  ExactPose axis;          ///< A
  bool is_turn = false;
  std::string name;
  std::vector<std::string> owners;
  Rational fixed = 0;  ///< o
  Polynomial unknown = {};
};

/// E_1 E_2 ... ~ whole.
struct JointLoop {
  std::vector<LoopElement> elements;
  ExactPose whole;
};

/// Places of its turns.
std::vector<std::size_t> turns_of(const JointLoop& loop);

/// Begun at every element, both ways round.
std::vector<JointLoop> all_ways(const JointLoop& loop);

/// b0 and b1.
std::array<ExactPose, 2> basis_of(const LoopElement& element);
/// E
MovingPose element_pose(const LoopElement& element);

}  // namespace moivre
