// SPDX-License-Identifier: MIT
// How do words become an exit code? The command line is parsed, the command run, and errors are
// told on stderr.
//
//   0  every path was decided (no root is an answer too)     2  a path failed, or the run was
//      interrupted
//   1  the call or the file is wrong                         3  a fault of ours
#pragma once

namespace moivre {

enum ExitCode : int { kDecided = 0, kUsage = 1, kUndecided = 2, kInternal = 3 };

int run_command_line(int argc, char** argv) noexcept;

}  // namespace moivre
