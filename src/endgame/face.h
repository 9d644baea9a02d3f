// SPDX-License-Identifier: MIT
// Does a path that grows really go to infinity? Only where the terms that dominate in its direction
// have a root of their own.
//
//   x_j / x_0 ~ a_j r^{w_j}, r = 1 - t: term k of equation i is of order o_k = v_k + <a_k, w>; v_k
//   = 0 where F has the term, 1 where only G has it, whose coefficient vanishes with r. The terms
//   of least order of each equation are its face.
//
// A path to infinity makes the faces vanish together, at a point of the torus near its own: by
// [Bernstein75], theorem B, a generic system has no such point in any direction, since the faces
// are n equations for what are n - 1 unknowns. A path that merely grows for a while, to a large
// finite root, finds none. So its direction is taken for that of an end at infinity where Newton's
// method in log x, from the path's own point, makes all faces vanish to the rounding of
// double-double, and nowhere else.
// Where the file's numbers were rounded (Homotopy::errors) faces whose values are within the sum of
// all errors may vanish for another system that the file may mean. Whether the ends do go to
// infinity for it, the samples tell (file_errors.h).
//
//   w: valuations, rounded to fractions of the least denominator that they allow
//   Edges: a face of one term cannot vanish. Coordinates that are 0 have no valuation, and terms
//   with them no part.
// Private to the module. Source: [Bernstein75], [HuberVerschelde98].
#pragma once

#include <vector>

#include "moivre/endgame/end_parameters.h"
#include "moivre/tracker/path_system.h"

namespace moivre {

enum class FaceRoot {
  none,
  exact,
  as_rounded  ///< perhaps, of faces whose coefficients differ from F's by less than their errors
};

/// x: homogeneous, not in a frame, at 1 - t = radius. valuations: of x_j / x_0, n of them.
FaceRoot face_root(PathSystem& path, const Point& x, double radius,
                   const std::vector<double>& valuations, const EndParameters& ends);

}  // namespace moivre
