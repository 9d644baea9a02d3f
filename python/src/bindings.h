// SPDX-License-Identifier: MIT
// Which parts has the compiled half of the Python module? Each binds one subject; python/moivre/
// gives it its face.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "moivre/solver/solve.h"

namespace moivre::python {

/// A system and what its solve found.
struct Solved {
  System system;
  SolveResult result;
};

/// "proved", "shown", "open" or None.
pybind11::object completeness_of(const std::optional<RootCompleteness>& completeness);
pybind11::dict counts_of(const PathCounts& paths);

void bind_systems(pybind11::module_& module);
void bind_families(pybind11::module_& module);
void bind_mechanisms(pybind11::module_& module);
void bind_arms(pybind11::module_& module);

}  // namespace moivre::python
