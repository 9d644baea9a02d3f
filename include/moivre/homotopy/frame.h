// SPDX-License-Identifier: MIT
// In which units is one path followed? In its own: coordinates of sizes near 1 where it sets out, equations near 1 too.
//
//   x_j = 2^{e_j} y_j,  e_j from a point of the path;  term k of equation i carries 2^{<a_k, e> + r_i}, r_i so that the
//   largest term's coefficient is near 1. Where the homotopy is toric a path's weights w_k stand here too.
//
// Sizes from 1e-300 to 1e300 then look alike to norms, pivots and tolerances. Powers of two round nothing. The point is
// followed in y (`inside`), whoever looks at it from without wants x (`outside`).
// Only a homotopy that is_framed() takes notice of units and weights. Where every path has a family's member of its own for
// its target (Homotopy::members) that is all that its frame holds.
#pragma once

#include <memory>
#include <vector>

#include "moivre/numeric/complex.h"

namespace moivre {

class Homotopy;

struct PathFrame {
  std::vector<int> log2;        ///< e_j, one a coordinate
  std::vector<double> factors;  ///< 2^{<a_k, e> + r_i}, one a term of the homotopy
  std::vector<double> weights;  ///< w_k of a toric homotopy; empty otherwise
  Point member = {};            ///< p' of a homotopy of members; empty otherwise
};
/// Who follows the path holds it; nullptr: x itself.
using FramePointer = std::shared_ptr<const PathFrame>;

/// Of a framed homotopy: the frame in which x, homogeneous, has coordinates near 1. Coordinates of x that are 0 stay as they are.
PathFrame frame_at(const Homotopy& homotopy, const Point& x);

/// y of x, and x of y; the point itself where there is no frame.
Point inside(const FramePointer& frame, Point x);
Point outside(const FramePointer& frame, Point y);

}  // namespace moivre
