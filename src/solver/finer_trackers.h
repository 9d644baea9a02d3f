// SPDX-License-Identifier: MIT
// Which trackers have more digits than double-double? Each more than the one before; none where the
// module multiprecision was not built. Private to the module.
#pragma once

#include <memory>
#include <vector>

#include "moivre/tracker/tracker.h"

namespace moivre {

std::vector<std::unique_ptr<Tracker>> make_finer_trackers();

}  // namespace moivre
