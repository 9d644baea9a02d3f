// SPDX-License-Identifier: MIT
// Sensitivities as a table: one line per closure and dimension.
#include "moivre/closure_report/sensitivity_report.h"
#include "moivre/report/csv_cell.h"
#include "moivre/report/number_text.h"

namespace moivre {
namespace {

using Eigen::Index;

std::string name_of(const SensitiveQuantity& quantity) {
  constexpr const char* kAxes[] = {".x", ".y", ".z"};
  switch (quantity.group) {
    case SensitiveGroup::point:
      return quantity.name + kAxes[quantity.axis];
    case SensitiveGroup::joint:
      return "joint " + quantity.name;
    case SensitiveGroup::coordinate:
      break;
  }
  return quantity.name;
}

/// How many of the form's units make one of a kind: radians, or the file's unit of length.
double units_in(CoordinateKind kind, const AngleForm& form) { return in_form(1, kind, form); }

}  // namespace

std::string sensitivity_csv(const Sensitivities& told, const Mechanism& mechanism,
                            const AngleForm& form) {
  std::string text = "id,dimension,unit,value,tolerance";
  for (const SensitiveQuantity& quantity : told.quantities) {
    text += ',' + column_name(name_of(quantity), quantity.kind, form);
  }
  text += '\n';
  for (const ClosureSensitivity& closure : told.closures) {
    for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
      const bool is_angle = told.dimensions[k].is_angle;
      const double unit = units_in(is_angle ? CoordinateKind::angle : CoordinateKind::length, form);
      text += closure.id + ',' + csv_cell(told.dimensions[k].name) + ',' +
              (is_angle ? unit_of(form) : mechanism.units.length) + ',' +
              exact_text(told.values[k] * unit) + ',' + exact_text(told.tolerances[k] * unit);
      for (std::size_t i = 0; i < told.quantities.size(); ++i) {
        const double rate = closure.rates(static_cast<Index>(i), static_cast<Index>(k));
        text += ',' + exact_text(rate * units_in(told.quantities[i].kind, form) / unit);
      }
      text += '\n';
    }
    if (!told.has_tolerances()) continue;
    const auto add_spread = [&](const char* name, const Eigen::VectorXd& spread) {
      text += closure.id + ',' + name + ",,,";
      for (std::size_t i = 0; i < told.quantities.size(); ++i) {
        text += ',' +
                exact_text(spread[static_cast<Index>(i)] * units_in(told.quantities[i].kind, form));
      }
      text += '\n';
    };
    add_spread("worst case", closure.worst_case);
    add_spread("root sum square", closure.root_sum_square);
  }
  return text;
}

}  // namespace moivre
