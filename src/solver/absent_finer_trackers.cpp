// SPDX-License-Identifier: MIT
// The module multiprecision was not built.
#include "finer_trackers.h"

namespace moivre {

std::vector<std::unique_ptr<Tracker>> make_finer_trackers() { return {}; }

}  // namespace moivre
