// SPDX-License-Identifier: MIT
// moivre closures ARM.urdf: which options say what is asked of a robot, and what answers them?
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common_options.h"
#include "kept_run.h"
#include "moivre/expression/source.h"
#include "tracker_choice.h"

namespace moivre {

struct ArmOptions {
  std::string base, tip;
  std::string pose;   ///< "x y z qw qx qy qz"
  std::string poses;  ///< a file of them
  std::optional<double> pose_accuracy;
  std::string nearest;            ///< joint values, separated by blanks or commas
  std::string limits;             ///< "wrap", or none
  std::vector<std::string> held;  ///< "JOINT=VALUE"
  std::string sweep_hold;         ///< "JOINT=FROM:TO:N"
  std::string loops;              ///< a side file
};

/// "--tip", "--pose", "--hold" and "--loops", of every command that takes a robot.
void add_robot_options(CLI::App& command, ArmOptions& options);
/// And those of closures alone.
void add_arm_options(CLI::App& command, ArmOptions& options);
/// Whether any of them was given.
bool are_given(const ArmOptions& options);

/// The robot as a mechanism file, with the loops that a side file closes. Throws ParseError,
/// std::invalid_argument.
std::string robot_as_mechanism(const std::string& file, const Source& source,
                               const ArmOptions& options);

/// What `moivre closures` was asked besides.
struct ArmRun {
  std::string file;
  ArmOptions arm;
  StartChoice start;
  TrackerChoice tracker;
  int threads = 0;
  bool quiet = false;
  bool in_degrees = false;
  bool three_views = false;
  std::string json, csv, svg, html;
  std::optional<double> time_limit;
  LedgerChoice ledger;
};

/// By its ending, or by its content where that says XML.
bool is_robot(const std::string& file, const Source& source);

/// All inverse kinematics; the exit code.
int run_arm(const ArmRun& run, const Source& source);

}  // namespace moivre
