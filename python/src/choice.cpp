// SPDX-License-Identifier: MIT
// Trackers and options from a dictionary; what is not in it keeps the library's default.
#include "choice.h"

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "moivre/expression/joined.h"
#include "moivre/tracker/option_table.h"

#if MOIVRE_WITH_CVODE
#include "moivre/tracker_cvode/cvode_tracker.h"
#endif
#if MOIVRE_WITH_LANES
#include "moivre/tracker_lanes/lane_tracker.h"
#endif

namespace moivre::python {
namespace {

namespace py = pybind11;

[[maybe_unused]] OptionValue value_of(const OptionFacts& facts, const py::handle& given) {
  const std::string name = "tracker_options " + facts.name;
  if (std::holds_alternative<std::string>(facts.standard)) {
    return option_value<std::string>(name, given);
  }
  if (std::holds_alternative<std::int64_t>(facts.standard)) {
    return option_value<std::int64_t>(name, given);
  }
  return option_value<double>(name, given);
}

template <class Options>
Options chosen_options(const OptionTable<Options>& table, const py::dict& given) {
  Options options;
  std::vector<std::string> names;
  for (const auto& row : table) {
    names.push_back(row.facts.name);
    if (given.contains(row.facts.name.c_str())) {
      row.set(options, value_of(row.facts, given[row.facts.name.c_str()]));
    }
  }
  for (const auto& [key, value] : given) {
    const auto name = py::str(key).cast<std::string>();
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw std::invalid_argument("tracker_options: there is no " + name + "; there are " +
                                joined(names, ", "));
  }
  return options;
}

/// Those of `given` that the table has.
template <class Options>
py::dict common_options(const OptionTable<Options>& table, const py::dict& given) {
  py::dict common;
  for (const auto& row : table) {
    const char* const name = row.facts.name.c_str();
    if (given.contains(name)) common[name] = given[name];
  }
  return common;
}

std::unique_ptr<Tracker> make_one(const std::string& kind, const py::dict& options) {
#if MOIVRE_WITH_CVODE
  if (kind == "cvode") return make_cvode_tracker(chosen_options(cvode_table(), options));
#endif
#if MOIVRE_WITH_LANES
  if (kind == "lanes") return make_lane_tracker(chosen_options(lane_table(), options));
#endif
  const bool is_known = kind == "cvode" || kind == "lanes";
  throw std::invalid_argument("tracker \"" + kind + "\": " +
                              (is_known ? "this library was built without it"
                                        : "the trackers are \"cvode\" and \"lanes\""));
}

template <class Value>
void take(const py::dict& choice, const char* name, Value& value) {
  if (choice.contains(name)) value = option_value<Value>(name, choice[name]);
}

Precision precision_of(const std::string& name) {
  if (name == "auto") return Precision::automatic;
  if (name == "double") return Precision::double_precision;
  if (name == "double-double") return Precision::double_double;
  throw std::invalid_argument("precision \"" + name +
                              "\": the precisions are \"auto\", \"double\" and \"double-double\"");
}

StartKind start_of(const std::string& name) {
  if (const auto kind = start_kind(name)) return *kind;
  throw std::invalid_argument("start \"" + name +
                              "\": the start systems are \"auto\", \"total-degree\", "
                              "\"multihomogeneous\" and \"polyhedral\"");
}

}  // namespace

Trackers make_trackers(const py::dict& choice) {
  std::string kind = MOIVRE_WITH_CVODE ? "cvode" : "lanes";
  py::dict options;
  take(choice, "tracker", kind);
  take(choice, "tracker_options", options);
  Trackers trackers;
  trackers.chosen = make_one(kind, options);
  const bool has_other = kind == "cvode" ? MOIVRE_WITH_LANES : MOIVRE_WITH_CVODE;
  if (has_other && kind == "cvode") {
    trackers.other = make_one("lanes", common_options(lane_table(), options));
  } else if (has_other) {
    trackers.other = make_one("cvode", common_options(cvode_table(), options));
  }
  return trackers;
}

SolveOptions solve_options(const py::dict& choice, const Trackers& trackers) {
  SolveOptions options;
  std::string start = "auto";
  std::string precision = "auto";
  take(choice, "seed", options.seed);
  take(choice, "start", start);
  take(choice, "threads", options.threads);
  take(choice, "slice", options.slice);
  take(choice, "precision", precision);
  take(choice, "certify", options.certify);
  take(choice, "every_path", options.every_path);
  options.start = start_of(start);
  options.precision = precision_of(precision);
  options.fallback = trackers.other.get();
  return options;
}

Terms terms_of(const py::dict& choice, const py::object& progress) {
  Terms terms{progress, std::nullopt};
  if (choice.contains("ledger")) terms.ledger = choice["ledger"].cast<CallLedger*>();
  if (!choice.contains("time_limit")) return terms;
  const auto seconds = option_value<double>("time_limit", choice["time_limit"]);
  if (!(seconds > 0)) throw std::invalid_argument("time_limit: seconds above 0 are wanted");
  terms.time_limit = seconds;
  return terms;
}

SolveOptions overseen_by(Oversight& oversight, SolveOptions options) {
  RunLedger* const book = oversight.ledger() != nullptr ? &oversight.ledger()->book() : nullptr;
  options.observations = book;
  options.progress = [&oversight, book](const Progress& progress) {
    oversight.tell(progress.done, progress.total);
    if (book != nullptr && !progress.search) {
      book->tell(progress.done, progress.total, progress.finite);
    }
  };
  return options;
}

}  // namespace moivre::python
