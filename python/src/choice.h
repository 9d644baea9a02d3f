// SPDX-License-Identifier: MIT
// Which tracker, and which options of a solve, does a dictionary of Python name? The words are those of the command line.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "moivre/solver/solve.h"
#include "overseen.h"

namespace moivre::python {

/// The one that is chosen, and the other, which takes over what it leaves in doubt (nullptr where it was not built).
struct Trackers {
  std::unique_ptr<Tracker> chosen;
  std::unique_ptr<Tracker> other;
};

/// choice["tracker"]: "cvode" (the default where it was built) or "lanes"; choice["tracker_options"]: a dictionary, by the options' names in
/// JSON. Throws std::invalid_argument.
Trackers make_trackers(const pybind11::dict& choice);

/// seed, start, threads, slice, precision, certify. Throws std::invalid_argument. `trackers` must outlive the options.
SolveOptions solve_options(const pybind11::dict& choice, const Trackers& trackers);

/// The same options, whose progress counts in `oversight`: of a thread that works, which may touch nothing of Python's.
SolveOptions overseen_by(Oversight& oversight, SolveOptions options);

}  // namespace moivre::python
