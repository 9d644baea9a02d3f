// SPDX-License-Identifier: MIT
// A loop begun elsewhere, and read backwards.
#include "joint_loop.h"

#include <algorithm>

namespace moivre {
namespace {

/// E_2 ... E_k (whole^-1 E_1 whole) ~ whole.
JointLoop turned_on(JointLoop loop) {
  LoopElement first = loop.elements.front();
  loop.elements.erase(loop.elements.begin());
  first.axis = 1 / norm(loop.whole) * (conjugate(loop.whole) * first.axis * loop.whole);
  loop.elements.push_back(std::move(first));
  return loop;
}

/// conj(E_k) ... conj(E_1) ~ conj(whole).
JointLoop reversed(JointLoop loop) {
  std::reverse(loop.elements.begin(), loop.elements.end());
  for (LoopElement& element : loop.elements) element.axis = conjugate(element.axis);
  loop.whole = conjugate(loop.whole);
  return loop;
}

}  // namespace

std::vector<std::size_t> turns_of(const JointLoop& loop) {
  std::vector<std::size_t> turns;
  for (std::size_t k = 0; k < loop.elements.size(); ++k) {
    if (loop.elements[k].is_turn) turns.push_back(k);
  }
  return turns;
}

std::vector<JointLoop> all_ways(const JointLoop& loop) {
  std::vector<JointLoop> ways;
  for (JointLoop way : {loop, reversed(loop)}) {
    for (std::size_t k = 0; k < loop.elements.size(); ++k) {
      ways.push_back(way);
      way = turned_on(std::move(way));
    }
  }
  return ways;
}

std::array<ExactPose, 2> basis_of(const LoopElement& element) {
  const ExactPose one = ExactPose::identity();
  const ExactPose moved = element.axis + (-element.fixed) * one;
  if (!element.is_turn) return {one, moved};
  return {one + element.fixed * element.axis, moved};
}

MovingPose element_pose(const LoopElement& element) {
  const auto basis = basis_of(element);
  return to_moving(basis[0]) + element.unknown * to_moving(basis[1]);
}

}  // namespace moivre
