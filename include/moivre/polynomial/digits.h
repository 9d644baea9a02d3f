// SPDX-License-Identifier: MIT
// How exact are the coefficients of a file? Numbers that were rounded are known to half a unit of
// their last digit.
//
//   c = p / q:  q divides 10^k, k >= 1 least, ten or more significant digits:   known to 0.5 10^-k;
//               from 15 digits on to a double's error
//               q = 2^j 10^k, j >= 40:  computed from doubles by a few operations: known to 2^-49
//                                       |c|
//               eight or nine digits beside such numbers: its last zeros were not written, known to
//               0.05 10^-k any other number, 31/10, 1/3, or a whole one, is meant as it stands
//
// Where the file's own numbers are known (System::is_exact) they decide, not what they multiply out
// to.
// If something vanishes within the errors of all coefficients, it vanishes for some system that the
// file may mean.
#pragma once

#include <vector>

#include "moivre/polynomial/number_errors.h"
#include "moivre/polynomial/system.h"

namespace moivre {

/// Of each term of each polynomial, relative to its coefficient.
using CoefficientErrors = std::vector<std::vector<NumberErrors>>;

/// Whether a number that is typed as such was rounded.
bool is_rounded(const Rational& a);

/// Of f as read, where each rounded coefficient is a number of its own; empty where all are exact.
CoefficientErrors coefficient_errors(const System& f);

}  // namespace moivre
