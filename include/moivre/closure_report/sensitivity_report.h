// SPDX-License-Identifier: MIT
// How is told by how much closures move with their dimensions? One table per closure for people,
// rows for programs.
//
//   text  the points whose curves say most (those without a joint, else those of floating links):
//         which dimensions move them most, and their spread; angles and slides, by the dimension
//         that changes them most; what is missing and why
//   CSV   one line per closure and dimension: its value, its tolerance, and the rate of each
//         quantity; with tolerances two more lines, "worst case" and "root sum square". A cell is
//         empty where there is none
//   JSON  what closures_json adds: `dimensions`, and of each closure `sensitivity` (docs/json.md)
// Angles in radians unless an AngleForm says otherwise, also those of dimensions; the text in the
// file's units.
#pragma once

#include <string>

#include "moivre/closure_report/angles.h"
#include "moivre/design/sensitivity.h"

namespace moivre {

std::string sensitivity_text(const Sensitivities& told, const Mechanism& mechanism);
std::string sensitivity_csv(const Sensitivities& told, const Mechanism& mechanism,
                            const AngleForm& form = {});

}  // namespace moivre
