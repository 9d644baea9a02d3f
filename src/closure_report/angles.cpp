// SPDX-License-Identifier: MIT
// Names and values of columns.
#include "moivre/closure_report/angles.h"

#include <numbers>

namespace moivre {

std::string unit_of(const AngleForm& form) { return form.in_degrees ? "deg" : "rad"; }

std::string column_name(const std::string& name, CoordinateKind kind, const AngleForm& form,
                        const std::string& per) {
  return kind == CoordinateKind::length ? name : name + " [" + unit_of(form) + per + "]";
}

double in_form(double value, CoordinateKind kind, const AngleForm& form) {
  const bool turns = kind != CoordinateKind::length && form.in_degrees;
  return turns ? value * 180 / std::numbers::pi : value;
}

CoordinateKind kind_of(const Mechanism& mechanism, const Driver& driver) {
  const bool is_angle = driver.kind == DriverKind::unknown
                            ? mechanism.unknowns[driver.unknown].is_angle
                            : driver.kind == DriverKind::angle;
  return is_angle ? CoordinateKind::angle : CoordinateKind::length;
}

std::string label_of(const Driver& driver) {
  const bool is_place =
      driver.kind == DriverKind::x || driver.kind == DriverKind::y || driver.kind == DriverKind::z;
  return is_place ? driver.name + "." + to_string(driver.kind) : driver.name;
}

}  // namespace moivre
