// SPDX-License-Identifier: MIT
// Which words does an option take? What completes a command line offers them; the option itself
// refuses others, in its own words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace moivre {

/// Notes the words with the option. They check nothing and are not shown by --help, whose sentence
/// names them.
void offer(CLI::Option& option, const std::vector<std::string>& words);

/// What the checks of an option say of themselves in --help, the last one first: "{rad,deg}".
std::vector<std::string> checks_of(CLI::Option& option);

/// The words of offer(), or those that the option's own check {one,other} names; empty where it
/// takes others.
std::vector<std::string> offered(CLI::Option& option);

}  // namespace moivre
