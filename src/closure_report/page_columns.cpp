// SPDX-License-Identifier: MIT
// Quantities by what they are of, and their values by time.
#include "page_columns.h"

#include "moivre/closure_report/document.h"
#include "readings_parts.h"

namespace moivre {
namespace {

/// Indices of the quantities of one thing: its value alone, or with velocity and acceleration.
using Plotted = std::vector<std::size_t>;

std::vector<Plotted> plotted_of(const std::vector<Quantity>& quantities) {
  std::vector<Plotted> all;
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const bool goes_with_last = quantities[k].order != QuantityOrder::value && !all.empty();
    if (goes_with_last) {
      all.back().push_back(k);
    } else {
      all.push_back({k});
    }
  }
  return all;
}

std::string with_superscript(std::string unit) {
  if (const std::size_t at = unit.find("^2"); at != std::string::npos)
    unit.replace(at, 2, "\u00b2");
  return unit;
}

}  // namespace

PageColumns page_columns(const Readings& readings, const MotionResult& motion,
                         const Mechanism& mechanism) {
  AngleForm form{mechanism.units.angle == "deg", true};
  PageColumns columns;
  const std::vector<Plotted> plotted = plotted_of(readings.quantities);
  for (const Plotted& one : plotted) {
    Json units = Json::array();
    for (const std::size_t k : one) {
      units.push_back(with_superscript(unit_text(readings.quantities[k], form)));
    }
    columns.quantities.push_back(
        {{"name", readings.quantities[one.front()].name}, {"units", units}});
  }
  for (std::size_t b = 0; b < motion.branches.size(); ++b) {
    const MotionBranch& branch = motion.branches[b];
    Json series = Json::array();
    for (const Plotted& one : plotted) {
      Json kinds = Json::array();
      for (const std::size_t k : one) {
        Json values = Json::array();
        if (branch.begin_event) values.push_back(nullptr);
        for (const std::vector<double>& row : readings.branches[b].values) {
          values.push_back(rounded(shown_value(row[k], readings.quantities[k], form)));
        }
        if (branch.end_event) values.push_back(nullptr);
        kinds.push_back(std::move(values));
      }
      series.push_back(std::move(kinds));
    }
    columns.ids.push_back(branch.id);
    columns.series.push_back(std::move(series));
  }
  return columns;
}

}  // namespace moivre
