// SPDX-License-Identifier: MIT
// How exact are the coefficients of a file? Numbers that were rounded are known to half a unit of their last digit.
//
//   c = p / q:  q divides 10^k, k >= 1 least, ten or more significant digits:   known to 0.5 10^-k; from 15 digits on to a double's error
//               q = 2^k, k >= 40: of 53 bits a double, computed by a few operations: known to 2^-49 |c|; of more: known to 2^-k / 2
//               any other number, 31/10, 1/3, or a whole one, is meant as it stands
//
// The file's error is that of its worst coefficient, and so is the error of each long number that was computed from it. If something
// vanishes within this error, it vanishes for some system that the file may mean.
#pragma once

#include "moivre/polynomial/system.h"

namespace moivre {

/// Of f as read: the largest relative error of a coefficient; 0 where all are exact.
double coefficient_error(const System& f);

/// The real or imaginary part is longer than an exact number, whatever power of two it was scaled by.
bool is_computed(const Coefficient& c);

}  // namespace moivre
