// SPDX-License-Identifier: MIT
// Where is the loop cut open? Which neighbouring joints are eliminated linearly, so that few
// unknowns are left.
//
// All products of J_i, ..., J_i+m-1 lie in a linear space W of dual quaternions; the rest of the
// loop must lie in W, too: linear equations in its product, multilinear ones in its tangents.
//   two joints    dim W = 4; W meets Study's quadric in what the two joints do, and nothing else,
//                 unless their axes meet or are parallel: then W lies in the quadric, and a b - c d
//                 = 0 of the coordinates in W says what the two can do
//   three joints  dim W = 4 where they make a group: turns about one point, or a plane's motions.
//                 Found by exact rank.
#pragma once

#include "loop.h"
#include "moivre/numeric/exact_displacement.h"

namespace moivre {

enum class CutKind { two, two_in_quadric, three };

struct Cut {
  CutKind kind = CutKind::two;
  std::vector<std::size_t> inside;  ///< neighbouring joints, counted round the loop
  /// The other joints, in their order round the loop behind them.
  std::vector<std::size_t> outside;
  /// Of a slide outside: its unknown is s'/c' with c = c' + chart s', s = s', so that one that
  /// leaves, c = 0, has a finite unknown.
  int chart = 0;
  std::vector<ExactDisplacement> forms;  ///< that vanish on W
  /// Two joints in the quadric: the coordinates in W of products c c, c s, s c, s s.
  std::vector<ExactDisplacement> coordinates;
};

/// Whether the cut may be at the last joint and the first, with the pose between them.
enum class CutPlace { anywhere, away_from_pose };

Cut choose_cut(const Loop& loop, CutPlace place = CutPlace::anywhere);

/// The product of the joints outside, backwards, which the product of those inside must be:
/// coefficients of the monomials in the tangents; bit k of the index is the exponent of t_k+1.
template <class S>
std::vector<DualQuaternion<S>> outside_product(const Loop& loop, const Cut& cut,
                                               JointNumbers<S> numbers) {
  std::vector<DualQuaternion<S>> terms{DualQuaternion<S>::identity()};
  for (const std::size_t joint : cut.outside) {
    const auto& [before, one, plain] = loop.joints[joint].*numbers;
    DualQuaternion<S> step = plain;
    if (loop.joints[joint].is_slide) step.q[0] = step.q[0] + S(cut.chart) * one;
    const std::size_t size = terms.size();
    for (std::size_t k = 0; k < size; ++k) {
      const DualQuaternion<S> term = terms[k] * before;
      terms[k] = one * term;
      terms.push_back(term * step);
    }
  }
  for (DualQuaternion<S>& term : terms) {
    term = conjugate(term * (loop.joints[cut.inside.front()].*numbers).before);
  }
  return terms;
}

}  // namespace moivre
