// SPDX-License-Identifier: MIT
// How well does a file know its coefficients? Up to half a unit of the last digit, where numbers were rounded to be typed.
//
//   c = p / q:  q divides 10^k, k >= 1 least, ten or more significant digits:   known to 0.5 10^-k; from 15 digits on to a double's error
//               q = 2^k, k >= 40: of 53 bits a double, computed by a few operations: known to 2^-49 |c|; of more: known to 2^-k / 2
//               any other number, 31/10, 1/3, or a whole one, is meant as it stands
//
// A file is known as well as its worst coefficient, and so is each long number that was computed from it. What vanishes to within
// that vanishes for some system that the file may mean.
#pragma once

#include "moivre/polynomial/system.h"

namespace moivre {

/// Of f as read: the largest relative error of a coefficient; 0 where all are meant as they stand.
double coefficient_error(const System& f);

/// Real or imaginary part is longer than numbers that are meant as they stand, whatever power of two it was scaled by.
bool is_computed(const Coefficient& c);

}  // namespace moivre
