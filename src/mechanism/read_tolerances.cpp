// SPDX-License-Identifier: MIT
// Tolerances of points, faults by their place.
#include "read_tolerances.h"

#include <algorithm>

#include "moivre/mechanism/nearest.h"

namespace moivre {
namespace {

/// A tolerance that is not below 0, or a fault.
std::optional<double> checked(Reading& reading, const toml::node& node,
                              std::optional<double> value) {
  if (value && *value < 0) {
    reading.fault(node, "a tolerance is how far a number may be off, up or down: from 0 up");
    return std::nullopt;
  }
  return value;
}

/// One a coordinate, the same for all where one number is written.
std::optional<std::vector<double>> read_one_or_all(Reading& reading, const toml::node& node,
                                                   const std::string& what, std::size_t axes) {
  std::optional<std::vector<double>> values;
  if (node.is_array()) {
    values = reading.numbers(node, what, axes);
  } else if (const auto value = reading.number(node, what)) {
    values = std::vector<double>(axes, *value);
  }
  if (!values) return std::nullopt;
  for (const double value : *values) {
    if (!checked(reading, node, value)) return std::nullopt;
  }
  return values;
}

void put(const Body& body, const BodyPoint& point, const std::vector<double>& values,
         Mechanism& mechanism) {
  constexpr const char* kAxes[] = {".x", ".y", ".z"};
  for (std::size_t axis = 0; axis < values.size(); ++axis) {
    mechanism.tolerances[body.name + "." + point.name + kAxes[axis]] = values[axis];
  }
}

}  // namespace

std::optional<double> read_tolerance(Reading& reading, const toml::table& in) {
  const auto value = reading.number(in, "tolerance");
  return value ? checked(reading, *in.get("tolerance"), value) : std::nullopt;
}

void read_point_tolerances(Reading& reading, const toml::table& in, const Body& body,
                           Mechanism& mechanism) {
  const std::size_t axes = mechanism.space == Space::planar ? 2 : 3;
  if (const auto value = read_tolerance(reading, in)) {
    for (const BodyPoint& point : body.points) {
      put(body, point, std::vector<double>(axes, *value), mechanism);
    }
  }
  const toml::table* own = reading.table(in, "tolerances");
  if (own == nullptr) return;
  std::vector<std::string> known;
  for (const BodyPoint& point : body.points) known.push_back(point.name);
  for (const toml::key* key : reading.keys_in_order(*own)) {
    const std::string name(key->str());
    const auto at = std::find(known.begin(), known.end(), name);
    if (at == known.end()) {
      reading.fault(
          reading.position(key->source().begin),
          "body '" + body.name + "' has no point '" + name + "'" + suggestion(name, known));
      continue;
    }
    const std::string what = "the tolerance of '" + body.name + "." + name + "'";
    if (const auto values = read_one_or_all(reading, *own->get(name), what, axes)) {
      put(body, body.points[static_cast<std::size_t>(at - known.begin())], *values, mechanism);
    }
  }
}

}  // namespace moivre
