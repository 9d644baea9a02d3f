// SPDX-License-Identifier: MIT
// How well does a file know its coefficients? Up to half a unit of the last digit, where a number was rounded to be typed.
//
//   error of c = p / q, relative:
//     q divides 10^k, k >= 1 least, ten or more significant digits:   0.5 10^-k / |c|; from 15 digits on not below a double's
//     q = 2^k, k >= 40: a double's own, computed by a few operations:   2^-49
//     any other number, 31/10, 1/3, or a whole one, is meant as it stands:   0
//
// A system is known as well as its worst coefficient is. What vanishes to within this error vanishes for some system that the
// file may as well mean. Real and imaginary parts count each for itself, beside |c|.
#pragma once

#include "moivre/polynomial/system.h"

namespace moivre {

/// Relative, the largest of all coefficients; 0 where all are exact.
double coefficient_error(const System& f);

}  // namespace moivre
