// SPDX-License-Identifier: MIT
// At which ends is there one root, and how often? Only exact algebra tells that from several roots
// nearer to each other than digits part.
//
//   known   F vanishes at the simplest fractions near the end, and their local ring has as many
//           dimensions as paths end there
//   counted the dimension of the quotient ring is the sum of all multiplicities, and there are as
//   many different roots as ends
//
// Circles show that m roots lie within a ball. Where neither holds that is all that is said: a
// cluster. Private to the module.
#pragma once

#include "run.h"

namespace moivre {

/// Sets run.counted_ends.
void count_ends(Run& run);

}  // namespace moivre
