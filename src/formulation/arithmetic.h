// SPDX-License-Identifier: MIT
// Which sums of polynomials do formulations need beside those of polynomial/system.h? Differences.
#pragma once

#include "moivre/polynomial/system.h"

namespace moivre {

inline Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  return a + Coefficient{-1, 0} * b;
}
inline Polynomial operator-(const Polynomial& a) { return Coefficient{-1, 0} * a; }

}  // namespace moivre
