// SPDX-License-Identifier: MIT
// At which root of F does an end of R lie, if large coordinates cancel in the sums that eliminated
// unknowns are?
//
//   y of an end  --proof on R-->  y to more digits than double's  --restore-->  x, then rounded
//                                 --proof on F-->  a root
//
// R (k unknowns) is what elimination has left of F (n unknowns), x = restore(y):
// polynomial/eliminate.h. At y_1 = 1e16 the 16 digits of double leave an unknown x_2 = y_1 - y_2 of
// size 1 none. So the kept unknowns alone tell which root it is.
// Edges: an end that is no simple root of R is none of F; one with a kept unknown 0 is left to
// others. Private to the module.
#pragma once

#include <memory>
#include <optional>

#include "certificates.h"

namespace moivre {

/// Owns its memory; one a thread. R is compiled when it is first asked for a root.
class FineRestorer {
 public:
  /// `setting` must outlive it. most_bits: of the balls' arithmetic.
  FineRestorer(const Setting& setting, int most_bits) : setting_(setting), most_bits_(most_bits) {}

  /// The root of F at an end in the coordinates of the path, proved by `prover`; nullptr where
  /// nothing was eliminated or is proved.
  std::shared_ptr<const Certificate> proved(Prover& prover, const Point& homogeneous);

 private:
  const Setting& setting_;
  int most_bits_;
  std::optional<Prover> reduced_prover_;
};

}  // namespace moivre
