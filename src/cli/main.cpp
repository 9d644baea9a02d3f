// SPDX-License-Identifier: MIT
// The program `moivre`.
#include "command_line.h"

int main(int argc, char** argv) { return moivre::run_command_line(argc, argv); }
