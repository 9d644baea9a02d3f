// SPDX-License-Identifier: MIT
// How far are two roots apart, as far as double and what is known beyond it tell?
//
//   |a - b|_inf,   a = x + finer[0] + finer[1] + ...
//
// Private to the module.
#pragma once

#include "moivre/solver/solve.h"

namespace moivre {

/// Smaller parts than both have tell nothing.
double distance(const Solution& a, const Solution& b);

}  // namespace moivre
