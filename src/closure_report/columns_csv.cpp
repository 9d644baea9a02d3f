// SPDX-License-Identifier: MIT
// The chosen quantities as a table: one sample of one branch a line.
#include <cmath>
#include <numbers>

#include "moivre/closure_report/readings_report.h"
#include "moivre/report/csv_cell.h"
#include "moivre/report/number_text.h"
#include "readings_parts.h"

namespace moivre {

std::string column_name(const Quantity& quantity, const AngleForm& form) {
  return quantity.name + " [" + unit_text(quantity, form) + ']';
}

std::string unit_text(const Quantity& quantity, const AngleForm& form) {
  return quantity.is_angle ? unit_of(form) + quantity.unit : quantity.unit;
}

double in_form(double value, const Quantity& quantity, const AngleForm& form) {
  return in_form(value, quantity.is_angle ? CoordinateKind::angle : CoordinateKind::length, form);
}

std::string columns_csv(const MotionResult& motion, const Readings& readings,
                        const Mechanism& mechanism, const AngleForm& form) {
  std::string text = "branch,t";
  for (const Driver& driver : mechanism.drivers) {
    text += ',' + column_name("driver " + label_of(driver), kind_of(mechanism, driver), form);
  }
  for (const Quantity& quantity : readings.quantities)
    text += ',' + csv_cell(column_name(quantity, form));
  text += '\n';
  for (std::size_t b = 0; b < motion.branches.size(); ++b) {
    const MotionBranch& branch = motion.branches[b];
    for (std::size_t j = 0; j < branch.samples.size(); ++j) {
      const double time = branch.samples[j].time;
      text += branch.id + ',' + exact_text(time);
      const std::vector<double> drivers = driver_values(mechanism, time);
      for (std::size_t k = 0; k < drivers.size(); ++k) {
        text +=
            ',' + exact_text(in_form(drivers[k], kind_of(mechanism, mechanism.drivers[k]), form));
      }
      for (std::size_t k = 0; k < readings.quantities.size(); ++k) {
        const Quantity& quantity = readings.quantities[k];
        const double value = shown_value(readings.branches[b].values[j][k], quantity, form);
        text += ',' + exact_text(value);
      }
      text += '\n';
    }
  }
  return text;
}

double shown_value(double value, const Quantity& quantity, const AngleForm& form) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const bool is_brought_back = quantity.turns && !form.goes_on;
  return in_form(is_brought_back ? std::remainder(value, kTurn) : value, quantity, form);
}

}  // namespace moivre
