// SPDX-License-Identifier: MIT
// Mechanisms from files of either kind; guesses by coordinate name.
#include "mechanism_input.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "common_options.h"
#include "moivre/closures/guesses.h"
#include "moivre/mechanism/read.h"
#include "moivre/polynomial/read.h"
#include "suggest.h"

namespace moivre {
namespace {

/// NaN where the text is not one finite number.
double number_in(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  const bool is_whole = read.ec == std::errc() && read.ptr == end && std::isfinite(value);
  return is_whole ? value : std::numeric_limits<double>::quiet_NaN();
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

}  // namespace

bool is_mechanism_file(const std::string& file) {
  constexpr std::string_view kEnding = ".toml";
  return file.size() >= kEnding.size() && file.ends_with(kEnding);
}

Mechanism read_mechanism_file(const std::string& file) {
  return read_mechanism_file(file, read_source(file));
}

Mechanism read_mechanism_file(const std::string& file, const Source& source) {
  try {
    return read_mechanism(source);
  } catch (const ParseError& error) {
    if (is_mechanism_file(file)) throw;
    std::vector<Diagnostic> faults = error.diagnostics();
    faults.back().message += " (a mechanism is wanted; moivre solve takes a polynomial system)";
    throw ParseError(source, std::move(faults));
  }
}

Mechanism read_any_mechanism(const std::string& file) {
  return is_mechanism_file(file) ? read_mechanism(read_source(file))
                                 : typed_mechanism(read_system(read_source(file)));
}

void add_mechanism_options(CLI::App& command, MechanismChoice& choice) {
  command
      .add_option("--fit", choice.fit,
                  "accept closures that miss by no more than this length, in the file's unit; for "
                  "lengths that were rounded")
      ->type_name("LENGTH");
  command.add_flag("--meshings", choice.all_meshings,
                   "find closures in every meshing of the gears, not only in the drawn one");
}

void apply(const MechanismChoice& choice, Mechanism& mechanism) {
  if (choice.fit) {
    if (!(*choice.fit > 0) || !is_workable(*choice.fit)) {
      throw std::invalid_argument("--fit must be a length above 0");
    }
    mechanism.fit = choice.fit;
  }
  for (Joint& joint : mechanism.joints) joint.gear.has_all_meshings |= choice.all_meshings;
}

void add_angles_option(CLI::App& command, AngleForm& form) {
  command
      .add_option_function<std::string>(
          "--angles", [&form](const std::string& unit) { form.in_degrees = unit == "deg"; },
          "unit of angles in the CSV table, rad (the default) or deg; its columns name it")
      ->check(CLI::IsMember({"rad", "deg"}))
      ->type_name("UNIT");
}

void add_guess_options(CLI::App& command, GuessChoice& choice) {
  add_time_option(command, choice.at);
  command
      .add_option("--guess", choice.guesses,
                  "start value of a coordinate, angles in the file's unit; may be repeated")
      ->type_name("NAME=VALUE");
}

Eigen::VectorXd named_values(const Mechanism& mechanism, const std::vector<std::string>& settings,
                             const Eigen::VectorXd& base, bool in_units) {
  const std::vector<Coordinate> all = coordinates(mechanism);
  std::vector<std::string> names;
  for (const Coordinate& coordinate : all) names.push_back(coordinate.name);
  Eigen::VectorXd values = base;
  std::vector<bool> is_given(names.size());
  std::string faults;
  const auto add_fault = [&faults](const std::string& fault) {
    faults += (faults.empty() ? "" : "; ") + fault;
  };
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    const double value = number_in(equals == std::string::npos ? "" : setting.substr(equals + 1));
    const auto at = std::find(names.begin(), names.end(), name);
    if (name.empty()) {
      add_fault(setting + " is not NAME=VALUE");
    } else if (at == names.end()) {
      const auto known = nearest(name, names);
      add_fault(
          "there is no coordinate " + name +
          (known ? ", did you mean " + *known + "?" : "; the coordinates are " + listed(names)));
    } else if (std::isnan(value)) {
      add_fault(setting + " is not NAME=VALUE with a finite number");
    } else if (is_given[static_cast<std::size_t>(at - names.begin())]) {
      add_fault(name + " is given twice");
    } else {
      const auto k = static_cast<std::size_t>(at - names.begin());
      is_given[k] = true;
      const bool in_degrees =
          in_units && all[k].kind != CoordinateKind::length && mechanism.units.angle == "deg";
      const double held = in_degrees ? value * std::numbers::pi / 180 : value;
      const bool is_angle = all[k].kind != CoordinateKind::length;
      if (in_units && is_angle && !is_workable_angle(held)) {
        add_fault(setting + " is more than a million turns");
      } else if (!is_workable(held)) {
        add_fault(setting + " is beyond 1e50");
      }
      values[static_cast<Eigen::Index>(k)] = held;
    }
  }
  if (!faults.empty()) throw std::invalid_argument(faults);
  return values;
}

Eigen::VectorXd chosen_guess(const Mechanism& mechanism, const GuessChoice& choice) {
  return named_values(mechanism, choice.guesses, initial_guess(mechanism, choice.at), true);
}

}  // namespace moivre
