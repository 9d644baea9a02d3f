// SPDX-License-Identifier: MIT
// A designer's quantities as JSON: names and units, extremes, time ratios.
#include "readings_parts.h"

namespace moivre {
namespace {

Json extreme_json(const Extreme& extreme, const Mechanism& mechanism) {
  Json drivers = Json::array();
  for (const double value : driver_values(mechanism, extreme.time))
    drivers.push_back(to_json(value));
  return {{"value", to_json(extreme.value)},
          {"t", to_json(extreme.time)},
          {"drivers", drivers},
          {"refined", extreme.is_refined},
          {"unbounded", extreme.is_unbounded()}};
}

}  // namespace

Json columns_json(const Readings& readings) {
  return list_json(readings.quantities, [](const Quantity& quantity) {
    return Json{{"name", quantity.name}, {"unit", unit_text(quantity, {})}};
  });
}

Json row_json(const Readings& readings, const std::vector<double>& values, const AngleForm& form) {
  Json row = Json::array();
  for (std::size_t k = 0; k < values.size(); ++k) {
    row.push_back(to_json(shown_value(values[k], readings.quantities[k], {false, form.goes_on})));
  }
  return row;
}

Json extremes_json(const Readings& readings, const BranchReadings& branch,
                   const Mechanism& mechanism) {
  Json json = Json::object();
  for (std::size_t k = 0; k < readings.quantities.size(); ++k) {
    json[readings.quantities[k].name] = {
        {"least", extreme_json(branch.extremes[k].least, mechanism)},
        {"largest", extreme_json(branch.extremes[k].largest, mechanism)}};
  }
  return json;
}

Json time_ratios_json(const BranchReadings& branch) {
  return list_json(branch.time_ratios, [](const TimeRatio& ratio) {
    return Json{{"output", ratio.output},
                {"ratio", to_json(ratio.ratio)},
                {"rising_s", to_json(ratio.rising_s)},
                {"falling_s", to_json(ratio.falling_s)},
                {"least", to_json(ratio.from)},
                {"largest", to_json(ratio.to)}};
  });
}

}  // namespace moivre
