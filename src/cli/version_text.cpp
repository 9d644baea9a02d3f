// SPDX-License-Identifier: MIT
// The version and the list of what was built in, as the build handed them in.
#include "version_text.h"

#include "moivre/report/version.h"

#if MOIVRE_WITH_LANES
#include "moivre/expression/joined.h"
#include "moivre/tracker_lanes/lane_tracker.h"
#endif

namespace moivre {
namespace {

#if MOIVRE_WITH_LANES
std::string lanes_text() {
  return lane_target() + " with " + std::to_string(lane_width()) +
         " doubles; built in and runnable here: " + joined(lane_targets(), ", ");
}
#else
std::string lanes_text() { return "not built"; }
#endif

}  // namespace

std::string version_text(bool verbose) {
  std::string text = "moivre " + std::string(version());
  if (!verbose) return text;
  return text + "\ncomponents:  " + MOIVRE_COMPONENT_LIST +
         "\npackages:    " + MOIVRE_PACKAGE_LIST + "\ncompiler:    " + MOIVRE_COMPILER +
         "\nlanes:       " + lanes_text();
}

}  // namespace moivre
