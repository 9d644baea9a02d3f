// SPDX-License-Identifier: MIT
// Which tracker did the user choose, and with what options? One that this program was built without
// is refused by name.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "moivre/tracker/option_table.h"
#include "moivre/tracker/tracker.h"

namespace moivre {

struct TrackerChoice {
  std::string kind;  ///< default: cvode where it was built
  std::map<std::string, OptionValue>
      values;  ///< of every option of either tracker, by its name; default: the tracker's own
  std::vector<std::string> of_lanes;  ///< the flags given that only the lanes take
  TrackerChoice();
};

/// An option, and the trackers that have it.
struct TrackerOption {
  OptionFacts facts;
  std::vector<std::string> trackers;
};
/// Of all trackers, built or not; first those of one tracker alone.
std::vector<TrackerOption> tracker_options();
void add_tracker_options(CLI::App& command, TrackerChoice& choice);
/// Throws std::invalid_argument with the reason when there is no such tracker, an option is out of
/// range, or one is given that the tracker does not take and no `witness` does.
std::unique_ptr<Tracker> make_tracker(const TrackerChoice& choice, bool has_witness = false);
/// The other tracker, which takes over what the chosen one leaves in doubt; nullptr where it was
/// not built.
std::unique_ptr<Tracker> make_fallback(const TrackerChoice& choice);
/// The other tracker. Throws std::invalid_argument when this program was built without it.
std::unique_ptr<Tracker> make_witness(const TrackerChoice& choice);

}  // namespace moivre
