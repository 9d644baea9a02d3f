// SPDX-License-Identifier: MIT
// Which tracker, and which options of a solve, does a dictionary of Python name? The words are
// those of the command line.
#pragma once

#include <pybind11/pybind11.h>

#include <concepts>
#include <memory>
#include <stdexcept>
#include <string>

#include "moivre/solver/solve.h"
#include "overseen.h"

namespace moivre::python {

/// The one that is chosen, and the other, which takes over what it leaves in doubt (nullptr where
/// it was not built).
struct Trackers {
  std::unique_ptr<Tracker> chosen;
  std::unique_ptr<Tracker> other;
};

/// What an option of this type wants, in words.
template <class Value>
constexpr const char* wanted() {
  if constexpr (std::same_as<Value, bool>) return "True or False";
  if constexpr (std::unsigned_integral<Value>) return "a whole number from 0 up";
  if constexpr (std::integral<Value>) return "a whole number";
  if constexpr (std::floating_point<Value>) return "a number";
  if constexpr (std::same_as<Value, pybind11::dict>) return "a dictionary";
  return "a text";
}

/// The value of an option. Throws std::invalid_argument, with its name, where it is of another
/// kind.
template <class Value>
Value option_value(const std::string& name, const pybind11::handle& given) {
  try {
    return given.cast<Value>();
  } catch (const pybind11::cast_error&) {
    throw std::invalid_argument(name + ": " + pybind11::repr(given).cast<std::string>() +
                                " is given, but " + wanted<Value>() + " is wanted");
  }
}

/// choice["tracker"]: "cvode" (the default where it was built) or "lanes";
/// choice["tracker_options"]: a dictionary, by the options' names in JSON. Throws
/// std::invalid_argument.
Trackers make_trackers(const pybind11::dict& choice);

/// seed, start, threads, slice, precision, certify, every_path. Throws std::invalid_argument.
/// `trackers` must outlive the options.
SolveOptions solve_options(const pybind11::dict& choice, const Trackers& trackers);

/// choice["time_limit"] and choice["ledger"], a CallLedger, beside the function that is told of
/// progress. Throws std::invalid_argument.
Terms terms_of(const pybind11::dict& choice, const pybind11::object& progress);

/// The same options, whose progress counts in `oversight`: of a thread that works, which may touch
/// nothing of Python's.
SolveOptions overseen_by(Oversight& oversight, SolveOptions options);

}  // namespace moivre::python
