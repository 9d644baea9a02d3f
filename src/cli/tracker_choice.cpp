// SPDX-License-Identifier: MIT
// Makes the tracker that was chosen, of those that this program was built with.
#include "tracker_choice.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "choices.h"
#include "common_options.h"
#include "moivre/tracker/tracker_options.h"

#if MOIVRE_WITH_CVODE
#include "moivre/tracker_cvode/cvode_tracker.h"
#endif
#if MOIVRE_WITH_LANES
#include "moivre/tracker_lanes/lane_tracker.h"
#endif

namespace moivre {
namespace {

/// One with its options as chosen. All words that it does not take, and all numbers out of range,
/// are refused at once.
template <class Options>
std::unique_ptr<Tracker> made(const OptionTable<Options>& table, const TrackerChoice& choice,
                              std::unique_ptr<Tracker> (*make)(const Options&)) {
  Options options;
  std::unique_ptr<Tracker> tracker;
  std::vector<std::function<void()>> steps;
  for (const auto& row : table) {
    steps.emplace_back([&] { row.set(options, choice.values.at(row.facts.name)); });
  }
  steps.emplace_back([&] { tracker = make(options); });
  require_all(steps);
  return tracker;
}

#if MOIVRE_WITH_CVODE
std::unique_ptr<Tracker> make_cvode(const TrackerChoice& choice) {
  return made(cvode_table(), choice, make_cvode_tracker);
}
#else
std::unique_ptr<Tracker> make_cvode(const TrackerChoice&) {
  throw std::invalid_argument("--tracker cvode: this program was built without the CVODE tracker");
}
#endif

#if MOIVRE_WITH_LANES
std::unique_ptr<Tracker> make_lanes(const TrackerChoice& choice) {
  return made(lane_table(), choice, make_lane_tracker);
}
#else
std::unique_ptr<Tracker> make_lanes(const TrackerChoice&) {
  throw std::invalid_argument("--tracker lanes: this program was built without the lane tracker");
}
#endif

bool is_of_lanes_alone(const TrackerOption& option) {
  return option.trackers.size() == 1 && option.trackers.front() == "lanes";
}

}  // namespace

std::vector<TrackerOption> tracker_options() {
  std::vector<TrackerOption> options;
  const auto add = [&](const std::string& tracker, const std::vector<OptionFacts>& table) {
    for (const OptionFacts& facts : table) {
      const auto same = std::find_if(options.begin(), options.end(), [&](const auto& other) {
        return other.facts.name == facts.name;
      });
      if (same == options.end()) {
        options.push_back({facts, {tracker}});
      } else {
        same->trackers.push_back(tracker);
      }
    }
  };
  add("cvode", facts_of(cvode_table()));
  add("lanes", facts_of(lane_table()));
  std::stable_partition(options.begin(), options.end(),
                        [](const TrackerOption& option) { return option.trackers.size() == 1; });
  return options;
}

TrackerChoice::TrackerChoice() : kind(MOIVRE_WITH_CVODE ? "cvode" : "lanes") {
  for (const TrackerOption& option : tracker_options()) {
    values.emplace(option.facts.name, option.facts.standard);
  }
}

void add_tracker_options(CLI::App& command, TrackerChoice& choice) {
  const std::string group = "Tracker";
  CLI::Option* const tracker = command.add_option("--tracker", choice.kind, "cvode or lanes")
                                   ->capture_default_str()
                                   ->group(group);
  offer(*tracker, {"cvode", "lanes"});
  for (const TrackerOption& option : tracker_options()) {
    const std::string of = option.trackers.size() == 1 ? option.trackers.front() + ": " : "";
    const auto add = [&](auto& value) {
      return command.add_option(option.facts.flag, value, of + option.facts.sentence)
          ->capture_default_str()
          ->group(group);
    };
    CLI::Option* added = std::visit(add, choice.values.at(option.facts.name));
    offer(*added, option.facts.words);
    if (!is_of_lanes_alone(option)) continue;
    added->each([&choice, flag = option.facts.flag](const std::string&) {
      choice.of_lanes.push_back(flag);
    });
  }
}

std::unique_ptr<Tracker> make_tracker(const TrackerChoice& choice, bool has_witness) {
  if (choice.kind == "cvode" && !has_witness && !choice.of_lanes.empty()) {
    throw std::invalid_argument(choice.of_lanes.front() +
                                ": only the lanes take it (--tracker lanes)");
  }
  if (choice.kind == "cvode") return make_cvode(choice);
  if (choice.kind == "lanes") return make_lanes(choice);
  throw std::invalid_argument("--tracker " + choice.kind + ": the trackers are cvode and lanes");
}

std::unique_ptr<Tracker> make_fallback(const TrackerChoice& choice) {
  const bool is_built = choice.kind == "lanes" ? MOIVRE_WITH_CVODE : MOIVRE_WITH_LANES;
  return is_built ? make_witness(choice) : nullptr;
}

std::unique_ptr<Tracker> make_witness(const TrackerChoice& choice) {
  return choice.kind == "lanes" ? make_cvode(choice) : make_lanes(choice);
}

}  // namespace moivre
