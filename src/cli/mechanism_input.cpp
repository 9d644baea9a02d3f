// SPDX-License-Identifier: MIT
// Mechanisms from files of either kind; guesses by coordinate name.
#include "mechanism_input.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common_options.h"
#include "moivre/closures/guesses.h"
#include "moivre/mechanism/read.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/read.h"

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

/// "crank.phi=40"; without a number behind the sign the value is NaN.
NamedValue named_value(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  const double value = number_in(equals == std::string::npos ? "" : setting.substr(equals + 1));
  return {setting.substr(0, equals), value, setting};
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
    if (!(*choice.fit > 0)) throw std::invalid_argument("--fit must be a length above 0");
    if (!is_workable(*choice.fit)) {
      throw std::invalid_argument("--fit is a length beyond 1e50");
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
                             const Eigen::VectorXd& base, AngleUnit unit) {
  const std::vector<Coordinate> all = coordinates(mechanism);
  const auto is_known = [&all](const std::string& name) {
    return std::any_of(all.begin(), all.end(),
                       [&](const Coordinate& coordinate) { return coordinate.name == name; });
  };
  std::vector<NamedValue> given;
  std::vector<std::string> faults;
  for (const std::string& setting : settings) {
    const NamedValue value = named_value(setting);
    if (value.name.empty()) {
      faults.push_back(setting + " is not NAME=VALUE");
    } else if (std::isnan(value.value) && is_known(value.name)) {
      faults.push_back(setting + " is not NAME=VALUE with a finite number, without a unit");
    } else {
      given.push_back(value);
    }
  }
  const std::vector<std::string> broken = broken_rules(mechanism, given, unit);
  faults.insert(faults.end(), broken.begin(), broken.end());
  require_unbroken(faults);
  return with_values(mechanism, given, base, unit);
}

Eigen::VectorXd chosen_guess(const Mechanism& mechanism, const GuessChoice& choice) {
  return named_values(mechanism, choice.guesses, initial_guess(mechanism, choice.at),
                      AngleUnit::of_the_file);
}

}  // namespace moivre
