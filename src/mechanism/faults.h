// SPDX-License-Identifier: MIT
// Which rules does a mechanism break, and where in its file? For the reader, which has places, and
// for the rules, which have none.
#pragma once

#include <cstdint>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

using Faults = std::vector<Diagnostic>;

/// Of a gear.
inline constexpr std::int64_t kMostTeeth = 100000;

/// What one entry shows (moivre/mechanism/rules.h).
void find_form_faults(const Mechanism& mechanism, Faults& faults);
/// Of joints and of drivers, each in a file of its own.
void find_joint_faults(const Mechanism& mechanism, Faults& faults);
void find_driver_faults(const Mechanism& mechanism, Faults& faults);
/// Empty where the formula can be evaluated with so many unknowns; else a clause.
std::string fault_of(const Formula& formula, std::size_t unknowns);

/// What no single entry shows, of a mechanism whose form is whole.
void find_structure_faults(const Mechanism& mechanism, Faults& faults);

}  // namespace moivre
