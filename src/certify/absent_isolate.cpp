// SPDX-License-Identifier: MIT
// Roots of one unknown where the program was built without Arb: none is isolated.
#include "moivre/certify/isolate.h"

namespace moivre {

std::optional<IsolatedRoots> isolated_roots(const Polynomial&, int) { return std::nullopt; }

}  // namespace moivre
