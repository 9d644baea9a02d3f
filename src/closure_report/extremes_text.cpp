// SPDX-License-Identifier: MIT
// The least and the largest value of each quantity for people, a block a branch, in the file's
// units.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "moivre/closure_report/readings_report.h"
#include "moivre/mechanism/phi.h"
#include "moivre/report/number_text.h"
#include "readings_parts.h"

namespace moivre {
namespace {

using Row = std::array<std::string, 5>;

std::string six_digits(double x) {
  if (std::isnan(x)) return "-";
  if (std::isinf(x)) return x > 0 ? "unbounded" : "-unbounded";
  return short_text(x, 6);
}

std::string place_of(const Extreme& extreme, const Mechanism& mechanism) {
  if (std::isnan(extreme.value)) return "";
  // An extreme's place is known to fewer digits than its value.
  constexpr int kDigits = 5;
  constexpr double kNoise = 1e-7;  // radians, or of the mechanism's length
  if (mechanism.drivers.empty()) return "t = " + short_text(extreme.time, kDigits) + " s";
  const AngleForm form{mechanism.units.angle == "deg", true};
  const std::vector<double> values = driver_values(mechanism, extreme.time);
  const double length = Phi(mechanism).length();
  std::string text;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Driver& driver = mechanism.drivers[k];
    const CoordinateKind kind = kind_of(mechanism, driver);
    const bool is_angle = kind == CoordinateKind::angle;
    const std::string unit = is_angle ? unit_of(form) : mechanism.units.length;
    const double value = std::abs(values[k]) <= kNoise * (is_angle ? 1 : length) ? 0 : values[k];
    text += (k == 0 ? "" : ", ") + label_of(driver) + " = " +
            short_text(in_form(value, kind, form), kDigits) + (unit.empty() ? "" : " " + unit);
  }
  return text;
}

/// What is smaller relative to the largest number of its unit is rounding.
constexpr double kNoiseShare = 1e-11;

/// Largest finite magnitude of each unit over all branches.
std::map<std::string, double> unit_sizes(const Readings& readings) {
  std::map<std::string, double> size;
  for (const BranchReadings& branch : readings.branches) {
    for (std::size_t k = 0; k < readings.quantities.size(); ++k) {
      double& most = size[unit_text(readings.quantities[k], {})];
      for (const Extreme& end : {branch.extremes[k].least, branch.extremes[k].largest}) {
        if (std::isfinite(end.value)) most = std::max(most, std::abs(end.value));
      }
    }
  }
  return size;
}

/// Columns as wide as their widest cell; numbers end, words begin, at one place.
std::string aligned(const std::vector<Row>& rows) {
  std::array<std::size_t, 5> width{};
  for (const Row& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line = " ";
    for (std::size_t k = 0; k < row.size(); ++k) {
      const bool is_number = k == 1 || k == 3;
      const std::string gap(width[k] - row[k].size(), ' ');
      line += k == 0 || k == 2 || k == 4 ? " " : "  ";
      line += is_number ? gap + row[k] : row[k] + gap;
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

std::string time_ratio_text(const TimeRatio& ratio, const Mechanism& mechanism,
                            const AngleForm& form) {
  const double turn = ratio.rising_s + ratio.falling_s;
  const CoordinateKind kind = ratio.is_angle ? CoordinateKind::angle : CoordinateKind::length;
  const std::string unit = ratio.is_angle ? unit_of(form) : mechanism.units.length;
  const auto of_driver = [&](double seconds) {
    return six_digits(seconds) + " s (" +
           six_digits(in_form(2 * std::numbers::pi * seconds / turn, CoordinateKind::angle, form)) +
           ' ' + unit_of(form) + " of " + label_of(mechanism.drivers.front()) + ')';
  };
  return "  time ratio of " + ratio.output + ": " + six_digits(ratio.ratio) + "; from " +
         six_digits(in_form(ratio.from, kind, form)) + " to " +
         six_digits(in_form(ratio.to, kind, form)) + (unit.empty() ? "" : ' ' + unit) + " in " +
         of_driver(ratio.rising_s) + ", back in " + of_driver(ratio.falling_s) + '\n';
}

}  // namespace

std::string extremes_text(const Readings& readings, const Mechanism& mechanism) {
  AngleForm form;
  form.in_degrees = mechanism.units.angle == "deg";
  const std::map<std::string, double> size = unit_sizes(readings);
  std::string text;
  for (const BranchReadings& branch : readings.branches) {
    text += "\nextremes of branch " + branch.id + '\n';
    std::vector<Row> rows;
    for (std::size_t k = 0; k < readings.quantities.size(); ++k) {
      const Quantity& quantity = readings.quantities[k];
      const auto& [least, largest] = branch.extremes[k];
      const auto at = [&](const Extreme& extreme) {
        const std::string where = place_of(extreme, mechanism);
        return where.empty() ? where : "at " + where;
      };
      const double noise = kNoiseShare * size.at(unit_text(quantity, {}));
      const auto value = [&](const Extreme& extreme) {
        const double known = std::abs(extreme.value) <= noise ? 0 : extreme.value;
        return six_digits(in_form(known, quantity, form));
      };
      if (largest.value - least.value <= noise) {
        rows.push_back({column_name(quantity, form), value(least), "throughout", "", ""});
        continue;
      }
      rows.push_back(
          {column_name(quantity, form), value(least), at(least), value(largest), at(largest)});
    }
    text += aligned(rows);
    for (const TimeRatio& ratio : branch.time_ratios)
      text += time_ratio_text(ratio, mechanism, form);
  }
  return text;
}

}  // namespace moivre
