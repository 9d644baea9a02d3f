// SPDX-License-Identifier: MIT
// A loop begun elsewhere, and read backwards.
#include "loop.h"

#include <algorithm>

namespace moivre {
namespace {

/// E_2 ... E_k (whole^-1 E_1 whole) ~ whole.
Loop turned_on(Loop loop) {
  LoopElement first = loop.elements.front();
  loop.elements.erase(loop.elements.begin());
  first.axis = 1 / norm(loop.whole) * (conjugate(loop.whole) * first.axis * loop.whole);
  loop.elements.push_back(std::move(first));
  return loop;
}

/// conj(E_k) ... conj(E_1) ~ conj(whole).
Loop reversed(Loop loop) {
  std::reverse(loop.elements.begin(), loop.elements.end());
  for (LoopElement& element : loop.elements) element.axis = conjugate(element.axis);
  loop.whole = conjugate(loop.whole);
  return loop;
}

}  // namespace

std::size_t count_turns(const Loop& loop) {
  return static_cast<std::size_t>(
      std::count_if(loop.elements.begin(), loop.elements.end(),
                    [](const LoopElement& element) { return element.is_turn; }));
}

std::vector<Loop> all_ways(const Loop& loop) {
  std::vector<Loop> ways;
  for (Loop way : {loop, reversed(loop)}) {
    for (std::size_t k = 0; k < loop.elements.size(); ++k) {
      ways.push_back(way);
      way = turned_on(std::move(way));
    }
  }
  return ways;
}

std::array<ExactPose, 2> basis_of(const LoopElement& element) {
  const ExactPose one = identity_pose();
  const ExactPose moved = element.axis + (-element.fixed) * one;
  if (!element.is_turn) return {one, moved};
  return {one + element.fixed * element.axis, moved};
}

void exclude_endless(SpatialFrame& frame, const LoopElement& element) {
  if (element.is_turn) {
    frame.exclude(constant({1, 0}) + element.unknown * element.unknown,
                  "a half angle's tangent is i or -i there: nothing is turned");
  } else if (!element.fixed.is_zero()) {
    frame.exclude(constant({1, 0}) - Coefficient{element.fixed, 0} * element.unknown,
                  "a slide is infinitely long there");
  }
}

}  // namespace moivre
