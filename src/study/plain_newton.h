// SPDX-License-Identifier: MIT
// Where does Newton's method come to rest in plain double: coefficients, residuals and solves all
// rounded to 53 bits?
//
// The comparison for residuals in double-double. x: n, J: n x n; corrections dx = -J^{-1} F(x) are
// taken as long as they shrink, one at least, so that a root that is given with better residuals
// loses what plain double cannot see. Edges: a Jacobian that is singular ends it where it is.
#pragma once

#include "moivre/polynomial/tape.h"

namespace moivre {

class PlainNewton {
 public:
  explicit PlainNewton(const System& f);
  Point polish(Point x) const;

 private:
  Tape tape_;
  std::vector<Complex> coefficients_;
};

}  // namespace moivre
