// SPDX-License-Identifier: MIT
// The module multiprecision was not built: no root has more digits than double's.
#include <stdexcept>

#include "moivre/solver/digits.h"

namespace moivre {

void require_digits(int) { throw std::invalid_argument("this was built without multiprecision"); }

void give_digits(const System&, int digits, SolveResult&, const std::atomic<bool>&) {
  require_digits(digits);
}

int digits_that_part(const System&, const SolveResult&) { return 0; }

}  // namespace moivre
