// SPDX-License-Identifier: MIT
// Where does an end of R lie among the points of F, if large coordinates cancel in the sums that eliminated unknowns are?
//
//   y of an end  --Newton on R in balls-->  y to more digits than double's  --restore-->  x, then rounded
//
// R (k unknowns) is what elimination has left of F (n unknowns), x = restore(y): polynomial/eliminate.h. At y_1 = 1e16 the 16
// digits of double leave an unknown x_2 = y_1 - y_2 of size 1 none.
// Edges: where no simple root of R is proved near y there is no such x. Private to the module.
#pragma once

#include <optional>

#include "certificates.h"

namespace moivre {

/// Owns its memory; one a thread. R is compiled when it is first asked for a point.
class FineRestorer {
 public:
  /// `setting` must outlive it. most_bits: of the balls' arithmetic.
  FineRestorer(const Setting& setting, int most_bits) : setting_(setting), most_bits_(most_bits) {}

  /// x of an end in the coordinates of the path; nullopt where nothing was eliminated, or no root of R is proved there.
  std::optional<Point> restored(const Point& homogeneous);

 private:
  const Setting& setting_;
  int most_bits_;
  std::optional<Prover> prover_;
};

}  // namespace moivre
