// SPDX-License-Identifier: MIT
// In which unit is a designer's quantity shown, and what does JSON tell of it?
#pragma once

#include "moivre/closure_report/readings_report.h"
#include "moivre/report/json.h"

namespace moivre {

/// "deg/s", "mm", "-".
std::string unit_text(const Quantity& quantity, const AngleForm& form);
/// A value as the form has it, whole turns kept.
double in_form(double value, const Quantity& quantity, const AngleForm& form);
/// Likewise, an angle that turns in [-pi, pi] unless it goes on.
double shown_value(double value, const Quantity& quantity, const AngleForm& form);

/// [{"name", "unit"}], in radians.
Json columns_json(const Readings& readings);
/// The values of one sample, in the order of the columns.
Json row_json(const Readings& readings, const std::vector<double>& values, const AngleForm& form);
/// {"joint B": {"least": {...}, "largest": {...}}, ...}
Json extremes_json(const Readings& readings, const BranchReadings& branch,
                   const Mechanism& mechanism);
Json time_ratios_json(const BranchReadings& branch);

}  // namespace moivre
