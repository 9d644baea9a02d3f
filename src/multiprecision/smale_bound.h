// SPDX-License-Identifier: MIT
// What of Smale's gamma depends on F alone? The Bombieri-Weyl norms of its rows, and their degrees.
//
//   gamma <= max(1, |F| |J^{-1} Delta|) d^{3/2} / (2 |x|_1),   |x|_1^2 = 1 + sum |x_i|^2,   d = max
//   d_i,
//   Delta = diag(sqrt(d_i) |x|_1^{d_i - 1}),   |F_i|^2 = sum_e |c_e|^2 e! (d_i - |e|)! / d_i!
//
// Newton's method does not see the rows' sizes, so each is divided by its norm and |F| = sqrt(n).
// Source: [ShubSmale93, I-3], [HauensteinSottile12, prop. 5].
#pragma once

#include <vector>

#include "moivre/polynomial/system.h"

namespace moivre {

struct RowNorms {
  std::vector<double> log2_norm;  ///< log2 |F_i|
  std::vector<double> degree;     ///< d_i
  double terms = 0;               ///< of the longest row
};
RowNorms row_norms(const System& f);

}  // namespace moivre
