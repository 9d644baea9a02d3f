// SPDX-License-Identifier: MIT
// Do the linear equations of a block contradict each other, above a partial root? What a lone
// equation 0 x = b says of one unknown (lone_equation.h), of several.
//
//   slides along lines that are parallel:  s_1 d_1 + s_2 d_2 + s_3 d_3 = b,  d_1 = d_3 but for
//                                          rounding:  no root, unless b lies in the plane
//
// Where rounding makes the equations independent, their root lies at the rounding's inverse: at
// infinity, and on no set. Where they do not contradict each other, there is one.
// A x = b in units in which the sums of what the entries of A were added from are 1 at most. U_0:
// what A does not reach but for rounding; |U_0^T b| is by how much the equations contradict each
// other.
// Edges: less than clear in either respect, rank or contradiction, is no answer.
#pragma once

#include <optional>
#include <vector>

#include "moivre/closures/stages.h"
#include "moivre/formulation/block_structure.h"
#include "moivre/polynomial/system.h"

namespace moivre {

class LinearBlock {
 public:
  /// `all` must outlive it.
  LinearBlock(const System& all, const Block& block);

  /// Where the equations contradict each other: the shortest x that leaves least of them, in the
  /// order of the block's variables. It is no root, and rounded lengths may have made it none.
  std::optional<Point> least_squares(const PartialRoot& root) const;

 private:
  const System& all_;
  const Block& block_;
  bool is_linear_ = true;
};

}  // namespace moivre
