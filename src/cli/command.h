// SPDX-License-Identifier: MIT
// What is a command? It adds its options to the command line and, when it is chosen, runs to an exit code.
//
//   0  every path was decided (no root is an answer too)     2  a path failed, or the run was interrupted
//   1  the call or the file is wrong                         3  a fault of ours
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>
#include <string>

namespace moivre {

enum ExitCode : int { kDecided = 0, kUsage = 1, kUndecided = 2, kInternal = 3 };

/// The command that the user chose; it runs after all of the command line was understood.
using Chosen = std::function<int()>;

void add_solve_command(CLI::App& moivre, Chosen& chosen);

/// Parses, runs the command, tells errors on stderr. Returns the exit code; never throws.
int run_command_line(int argc, char** argv) noexcept;

}  // namespace moivre
