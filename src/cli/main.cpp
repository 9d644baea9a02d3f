// SPDX-License-Identifier: MIT
// The program `moivre`: all it does is in command_line.h.
#include "command_line.h"

int main(int argc, char** argv) { return moivre::run_command_line(argc, argv); }
