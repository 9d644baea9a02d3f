// SPDX-License-Identifier: MIT
// How do numbers go over to Arb and FLINT and come back? Integers limb by limb, doubles exactly.
#pragma once

#include "arb_ball.h"
#include "moivre/numeric/integer.h"

namespace moivre {

/// FLINT keeps free memory for each thread; it goes with the thread that used it.
struct FlintCaches {
  FlintCaches() = default;
  FlintCaches(const FlintCaches&) = delete;
  FlintCaches& operator=(const FlintCaches&) = delete;
  ~FlintCaches() { flint_cleanup(); }
};

void set(fmpz_t result, const Integer& value);

/// Adds a double, exactly.
void add_exactly(arb_t sum, double value);

/// Takes the double nearest to the midpoint off it, exactly.
double take_double(arb_t rest);

}  // namespace moivre
