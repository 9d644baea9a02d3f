// SPDX-License-Identifier: MIT
// How does a shell complete a command line of Moivre? A script for each shell: commands, options,
// their words and files.
#pragma once

#include <string>

#include "manual.h"

namespace moivre {

/// Needs no package besides bash.
std::string bash_completion(const ManualCommand& program);
std::string zsh_completion(const ManualCommand& program);
std::string fish_completion(const ManualCommand& program);

/// What an option or an argument takes, as far as a shell can tell. Every argument by its place is
/// a file.
enum class ValueKind { nothing, words, file, folder, other };
ValueKind taken_by(const ManualOption& option);

}  // namespace moivre
