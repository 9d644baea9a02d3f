// SPDX-License-Identifier: MIT
// The module multiprecision has them.
#include "finer_trackers.h"

#include "moivre/multiprecision/multiprecision_tracker.h"

namespace moivre {

std::vector<std::unique_ptr<Tracker>> make_finer_trackers() {
  std::vector<std::unique_ptr<Tracker>> trackers;
  for (const int digits : kTrackedDigits) trackers.push_back(make_multiprecision_tracker(digits));
  return trackers;
}

}  // namespace moivre
