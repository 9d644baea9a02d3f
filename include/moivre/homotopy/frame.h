// SPDX-License-Identifier: MIT
// In which units is one path followed? In its own: coordinates and equations are near 1 at its
// start.
//
//   x_j = 2^{e_j} y_j,  e_j from a point of the path;  term k of equation i carries 2^{<a_k, e> +
//                       r_i}, r_i so that the
//   largest term's coefficient is near 1. Where the homotopy is toric a path's weights w_k stand
//   here too.
//
// Norms, pivots and tolerances then work for sizes from 1e-300 to 1e300. Powers of two round
// nothing. The path is followed in y (`inside`); all other code uses x (`outside`).
// Only a homotopy that is_framed() uses units and weights. If every path has its own member of a
// family as its target (Homotopy::members), the frame holds that member and nothing else.
#pragma once

#include <memory>
#include <vector>

#include "moivre/numeric/complex.h"

namespace moivre {

class Homotopy;

struct PathFrame {
  std::vector<int> log2;        ///< e_j, one per coordinate
  std::vector<double> factors;  ///< 2^{<a_k, e> + r_i}, one a term of the homotopy
  std::vector<double> weights;  ///< w_k of a toric homotopy; empty otherwise
  Point member = {};            ///< p' of a homotopy of members; empty otherwise
};
/// Shared with the code that follows the path; nullptr: x itself.
using FramePointer = std::shared_ptr<const PathFrame>;

/// Of a framed homotopy: the frame in which x, homogeneous, has coordinates near 1. Coordinates of
/// x that are 0 stay as they are.
PathFrame frame_at(const Homotopy& homotopy, const Point& x);

/// y from x, and x from y; the point itself if there is no frame.
Point inside(const FramePointer& frame, Point x);
Point outside(const FramePointer& frame, Point y);

}  // namespace moivre
