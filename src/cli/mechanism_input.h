// SPDX-License-Identifier: MIT
// Which mechanism does the user mean, and from which guess? Mechanism, equation and polynomial
// files; NAME=VALUE options.
#pragma once

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "moivre/closure_report/angles.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/mechanism/named_values.h"

namespace moivre {

/// By the file's ending: .toml is a mechanism.
bool is_mechanism_file(const std::string& file);

/// A mechanism file, whatever its name. Throws ParseError, std::invalid_argument.
Mechanism read_mechanism_file(const std::string& file);
Mechanism read_mechanism_file(const std::string& file, const Source& source);

/// A mechanism file, or a polynomial file as a typed mechanism. Throws ParseError,
/// std::invalid_argument.
Mechanism read_any_mechanism(const std::string& file);

/// What a run changes of the mechanism in the file.
struct MechanismChoice {
  std::optional<double> fit;
  bool all_meshings = false;
};
void add_mechanism_options(CLI::App& command, MechanismChoice& choice);
/// Throws std::invalid_argument where a choice makes no sense.
void apply(const MechanismChoice& choice, Mechanism& mechanism);

/// "--angles" of tables.
void add_angles_option(CLI::App& command, AngleForm& form);

struct GuessChoice {
  double at = 0;                     ///< time of the drivers
  std::vector<std::string> guesses;  ///< "crank.phi=40", angles in the file's unit
};
void add_guess_options(CLI::App& command, GuessChoice& choice);

/// The file's initial guess with the user's values put in. Throws std::invalid_argument that names
/// every fault.
Eigen::VectorXd chosen_guess(const Mechanism& mechanism, const GuessChoice& choice);

/// A number a coordinate: `base` where the user gives none. Throws std::invalid_argument that names
/// every fault.
Eigen::VectorXd named_values(const Mechanism& mechanism, const std::vector<std::string>& settings,
                             const Eigen::VectorXd& base, AngleUnit unit);

}  // namespace moivre
