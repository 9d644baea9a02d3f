// SPDX-License-Identifier: MIT
// Names and values of columns.
#include "moivre/closure_report/angles.h"

#include <numbers>

#include "moivre/report/csv_cell.h"

namespace moivre {

std::string unit_of(const AngleForm& form) { return form.in_degrees ? "deg" : "rad"; }

std::string column_name(const std::string& name, CoordinateKind kind, const AngleForm& form,
                        const std::string& per) {
  return csv_cell(kind == CoordinateKind::length ? name : name + " [" + unit_of(form) + per + "]");
}

double in_form(double value, CoordinateKind kind, const AngleForm& form) {
  const bool turns = kind != CoordinateKind::length && form.in_degrees;
  return turns ? value * 180 / std::numbers::pi : value;
}

}  // namespace moivre
