// SPDX-License-Identifier: MIT
// Which exact number is this double? Itself: nothing is rounded between a start system and its
// start points. Private to the module.
#pragma once

#include "moivre/numeric/complex.h"
#include "moivre/numeric/rational.h"

namespace moivre {

inline Coefficient exact_coefficient(Complex c) { return {Rational(c.real()), Rational(c.imag())}; }

}  // namespace moivre
