// SPDX-License-Identifier: MIT
// Values sought out by the names of coordinates.
#include "moivre/mechanism/named_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "moivre/mechanism/nearest.h"
#include "moivre/numeric/invalid_input.h"

namespace moivre {
namespace {

std::vector<std::string> names_of(const std::vector<Coordinate>& all) {
  std::vector<std::string> names;
  for (const Coordinate& coordinate : all) names.push_back(coordinate.name);
  return names;
}

/// The first ones, where there are many.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kListed = 12;
  std::string text;
  for (std::size_t k = 0; k < std::min(kListed, names.size()); ++k) {
    text += (k == 0 ? "" : ", ") + names[k];
  }
  return names.size() > kListed ? text + ", ..." : text;
}

std::string stranger(const std::string& name, const std::vector<std::string>& names) {
  const auto known = nearest_word(name, names);
  return "there is no coordinate " + name +
         (known ? ", did you mean " + *known + "?" : "; the coordinates are " + listed(names));
}

/// In radians, or in the file's unit of length.
double held(const Mechanism& mechanism, const Coordinate& coordinate, double value,
            AngleUnit unit) {
  const bool in_degrees = unit == AngleUnit::of_the_file &&
                          coordinate.kind != CoordinateKind::length &&
                          mechanism.units.angle == "deg";
  return in_degrees ? value * std::numbers::pi / 180 : value;
}

/// Empty where it can be worked with.
std::string fault_of(const Mechanism& mechanism, const Coordinate& coordinate,
                     const NamedValue& given, AngleUnit unit) {
  if (!std::isfinite(given.value)) return given.said + " is not finite";
  const double value = held(mechanism, coordinate, given.value, unit);
  const bool is_angle = unit == AngleUnit::of_the_file && coordinate.kind != CoordinateKind::length;
  if (is_angle && !is_workable_angle(value)) return given.said + " is more than a million turns";
  return is_workable(value) ? "" : given.said + " is beyond 1e50";
}

}  // namespace

std::vector<std::string> broken_rules(const Mechanism& mechanism,
                                      const std::vector<NamedValue>& given, AngleUnit unit) {
  const std::vector<Coordinate> all = coordinates(mechanism);
  const std::vector<std::string> names = names_of(all);
  std::vector<bool> is_given(names.size());
  std::vector<std::string> broken;
  for (const NamedValue& each : given) {
    const auto at = std::find(names.begin(), names.end(), each.name);
    const auto k = static_cast<std::size_t>(at - names.begin());
    std::string fault;
    if (at == names.end()) {
      fault = stranger(each.name, names);
    } else if (is_given[k]) {
      fault = each.name + " is given twice";
    } else {
      is_given[k] = true;
      fault = fault_of(mechanism, all[k], each, unit);
    }
    if (!fault.empty()) broken.push_back(fault);
  }
  return broken;
}

Eigen::VectorXd with_values(const Mechanism& mechanism, const std::vector<NamedValue>& given,
                            const Eigen::VectorXd& base, AngleUnit unit) {
  require_unbroken(broken_rules(mechanism, given, unit));
  const std::vector<Coordinate> all = coordinates(mechanism);
  const std::vector<std::string> names = names_of(all);
  Eigen::VectorXd values = base;
  for (const NamedValue& each : given) {
    const auto k = std::find(names.begin(), names.end(), each.name) - names.begin();
    values[k] = held(mechanism, all[static_cast<std::size_t>(k)], each.value, unit);
  }
  return values;
}

}  // namespace moivre
