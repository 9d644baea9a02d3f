// SPDX-License-Identifier: MIT
// Which closures, complex ones too, does a root of the cut's equations mean? Tangents of all
// joints; or none.
//
// The tangents outside the cut are the root's. Their product, backwards, is what the joints inside
// must do: two are determined by its coordinates in W, three by a quadratic equation first. A root
// is none where a joint has no inverse (s/c = +-i), or where the product of the whole loop is not
// 1: then it belongs to the equations that were combined, or to W alone.
#pragma once

#include "cut.h"
#include "tip.h"

namespace moivre {

/// A complex closure: a place on its projective line for every joint of the loop.
struct LoopRoot {
  std::vector<Tangent> at;
  double imaginary = 0;  ///< the largest imaginary_part()
};

struct ReadBack {
  std::vector<LoopRoot> roots;
  bool moves =
      false;  ///< the joints inside move while the others stand: roots has one of the poses
};

/// `x`: the unknowns of cut_equations(), known to `accuracy` relative to max(1, |x|).
ReadBack read_back(const Loop& loop, const Cut& cut, const Point& x, double accuracy);

/// Its joint values, angles with real parts in (-pi, pi].
JointVector<Complex> values_of(const Loop& loop, const LoopRoot& root);

}  // namespace moivre
