// SPDX-License-Identifier: MIT
// How are the roots of a solve written with more digits than a double has? By Newton's method in
// multiprecision.
#pragma once

#include <atomic>

#include "moivre/polynomial/system.h"
#include "moivre/solver/solve.h"

namespace moivre {

/// Throws std::invalid_argument, with the reason, when this was built without multiprecision or
/// `digits` is not in [1, 1000].
void require_digits(int digits);

/// Fills `x_digits` of every root to which Newton's method converges; what has none, and why, joins
/// `left_out`. So do digits behind the 30th where numbers of the text, such as sqrt(2), have 40.
/// Once `stop` is true no further root is begun, and the result is not complete. Throws as
/// require_digits(), and std::invalid_argument where f is not square or has homogeneous groups.
void give_digits(const System& f, int digits, SolveResult& result, const std::atomic<bool>& stop);

/// How many digits part the roots that are proved to differ, but are one in double: 0 where there
/// are none, or none can be given.
int digits_that_part(const System& f, const SolveResult& result);

}  // namespace moivre
