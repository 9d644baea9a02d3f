// SPDX-License-Identifier: MIT
// What is a command? It adds its options to the command line and, when it is chosen, runs to an
// exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "command_line.h"

namespace moivre {

/// The command that the user chose; it runs after all of the command line was understood.
using Chosen = std::function<int()>;

/// Gives an empty `moivre` its options and its commands: only the one that the first of the words
/// names, else all.
void describe_program(CLI::App& moivre, Chosen& chosen, const std::vector<std::string>& words = {});

void add_solve_command(CLI::App& moivre, Chosen& chosen);
void add_track_command(CLI::App& moivre, Chosen& chosen);
void add_info_command(CLI::App& moivre, Chosen& chosen);
void add_closures_command(CLI::App& moivre, Chosen& chosen);
void add_motion_command(CLI::App& moivre, Chosen& chosen);
void add_newton_command(CLI::App& moivre, Chosen& chosen);
void add_mobility_command(CLI::App& moivre, Chosen& chosen);
void add_guesses_command(CLI::App& moivre, Chosen& chosen);
void add_mechanism_command(CLI::App& moivre, Chosen& chosen);
void add_study_command(CLI::App& moivre, Chosen& chosen);
void add_check_command(CLI::App& moivre, Chosen& chosen);
void add_family_command(CLI::App& moivre, Chosen& chosen);
void add_sweep_command(CLI::App& moivre, Chosen& chosen);
void add_ledger_command(CLI::App& moivre, Chosen& chosen);

}  // namespace moivre
