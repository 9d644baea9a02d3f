// SPDX-License-Identifier: MIT
// How are circuits told? A section of a motion's text, members of its JSON, a short name in pictures.
#pragma once

#include <string>

#include "moivre/closures/circuits.h"
#include "moivre/report/json.h"

namespace moivre {

/// "Circuits" and what follows; empty where there is no branch.
std::string circuits_text(const Circuits& circuits, const MotionResult& motion,
                          const Mechanism& mechanism);

/// Adds `full_turn`, `circuits`, `circuit_notes`, `pairs` and `four_bars`.
void add_circuits(const Circuits& circuits, const MotionResult& motion, const Mechanism& mechanism,
                  Json& report);

/// "circuit 2": of a branch.
std::string circuit_name(const Circuits& circuits, std::size_t branch);

}  // namespace moivre
