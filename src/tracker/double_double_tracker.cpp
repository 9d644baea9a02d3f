// SPDX-License-Identifier: MIT
// The tracker of fine_tracker.h in double-double.
#include "moivre/tracker/double_double_tracker.h"

namespace moivre {

std::unique_ptr<Tracker> make_double_double_tracker(const FineTrackerOptions& options) {
  return std::make_unique<FineTracker<ComplexDoubleDouble>>("double-double", options);
}

}  // namespace moivre
