// SPDX-License-Identifier: MIT
// Sensitivities as JSON: the contract of docs/json.md.
#include "sensitivity_json.h"

#include "pose_json.h"

namespace moivre {
namespace {

using Eigen::Index;

Json quantity_json(const Sensitivities& told, const ClosureSensitivity& closure, Index quantity) {
  Json json{{"rates", to_json(Eigen::VectorXd(closure.rates.row(quantity).transpose()))}};
  if (told.has_tolerances()) {
    json["worst_case"] = to_json(closure.worst_case[quantity]);
    json["root_sum_square"] = to_json(closure.root_sum_square[quantity]);
  }
  return json;
}

Json corner_json(const Sensitivities& told, const ClosureSensitivity& closure) {
  if (!closure.corner) return nullptr;
  constexpr const char* kAxes[] = {".x", ".y", ".z"};
  const SensitiveQuantity& quantity = told.quantities[closure.corner->quantity];
  const auto known = [](const std::optional<double>& x) { return x ? to_json(*x) : Json(nullptr); };
  return {{"quantity", quantity.name + kAxes[quantity.axis]},
          {"worst_case", to_json(closure.worst_case[static_cast<Index>(closure.corner->quantity)])},
          {"up", known(closure.corner->up)},
          {"down", known(closure.corner->down)}};
}

}  // namespace

Json dimensions_json(const Sensitivities& told) {
  Json json = Json::array();
  for (std::size_t k = 0; k < told.dimensions.size(); ++k) {
    json.push_back({{"name", told.dimensions[k].name},
                    {"kind", told.dimensions[k].is_angle ? "angle" : "length"},
                    {"value", to_json(told.values[k])},
                    {"tolerance", to_json(told.tolerances[k])}});
  }
  return json;
}

Json sensitivity_json(const Sensitivities& told, std::size_t number) {
  const ClosureSensitivity& closure = told.closures[number];
  Json coordinates = Json::object();
  Json points = Json::object();
  Json joints = Json::object();
  for (std::size_t k = 0; k < told.quantities.size(); ++k) {
    const SensitiveQuantity& quantity = told.quantities[k];
    Json json = quantity_json(told, closure, static_cast<Index>(k));
    switch (quantity.group) {
      case SensitiveGroup::coordinate:
        coordinates[quantity.name] = std::move(json);
        break;
      case SensitiveGroup::point:
        points[quantity.name].push_back(std::move(json));
        break;
      case SensitiveGroup::joint:
        joints[quantity.name] = std::move(json);
        break;
    }
  }
  Json json{
      {"determined", closure.missing.empty()},
      {"message", closure.missing.empty() ? "every rate is that of the implicit function theorem"
                                          : closure.missing},
      {"cannot_change_alone",
       list_json(closure.breaking, [&](std::size_t k) { return Json(told.dimensions[k].name); })},
      {"coordinates", std::move(coordinates)},
      {"points", std::move(points)},
      {"joints", std::move(joints)}};
  if (told.has_tolerances()) json["solved"] = corner_json(told, closure);
  return json;
}

}  // namespace moivre
