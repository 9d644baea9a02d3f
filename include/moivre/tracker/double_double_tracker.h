// SPDX-License-Identifier: MIT
// How is a path followed in double-double? As tracker/fine_tracker.h says, one path after the
// other.
#pragma once

#include "moivre/tracker/fine_tracker.h"

namespace moivre {

std::unique_ptr<Tracker> make_double_double_tracker(const FineTrackerOptions& options = {});

}  // namespace moivre
