// SPDX-License-Identifier: MIT
// How are a designer's quantities reported? Columns of a table, a table of extremes for people, and
// both for programs.
//
//   CSV   one sample per line: branch, t, drivers, then the quantities, each with its unit:
//         "coupler-rocker transmission [deg]";
//         a cell is empty where the quantity is not defined
//   text  one block per branch, one line per quantity: the least and the largest value and where
//         the drivers stand then; time ratios
//   JSON  what motion_json adds: `columns`, and of each branch `extremes` and `time_ratios`
//         (docs/json.md)
// Angles in radians unless an AngleForm says otherwise; the text in the file's units.
#pragma once

#include <string>

#include "moivre/closure_report/angles.h"
#include "moivre/design/readings.h"

namespace moivre {

/// "joint B.velocity [rad/s]", "d rocker.phi/d crank [-]".
std::string column_name(const Quantity& quantity, const AngleForm& form);

std::string columns_csv(const MotionResult& motion, const Readings& readings,
                        const Mechanism& mechanism, const AngleForm& form = {});

std::string extremes_text(const Readings& readings, const Mechanism& mechanism);

}  // namespace moivre
