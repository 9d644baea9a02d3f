// SPDX-License-Identifier: MIT
// In which unit does a table write angles, and do they jump at half a turn? Columns of angles name
// their unit: "crank.phi [rad]".
#pragma once

#include <string>

#include "moivre/closure_report/closure_report.h"

namespace moivre {

/// "deg" or "rad".
std::string unit_of(const AngleForm& form);

/// A column's name: that of a length as it is, that of an angle with its unit, " [rad]", and `per`
/// behind it, " [rad/s]".
std::string column_name(const std::string& name, CoordinateKind kind, const AngleForm& form,
                        const std::string& per = "");

/// A value of that kind (or its derivative) as the table writes it.
double in_form(double value, CoordinateKind kind, const AngleForm& form);

}  // namespace moivre
