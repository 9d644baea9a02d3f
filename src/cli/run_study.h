// SPDX-License-Identifier: MIT
// What does `moivre study` do with its files? Reads all of them, studies one after another, and
// tells.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study_settings.h"

namespace moivre {

struct StudyCommand {
  std::vector<std::string> files;
  StudyChoice choice;
  std::uint64_t seed = 1;
  int seeds = 3;
  std::optional<std::uint64_t> count;  ///< roots with multiplicity, where the user knows
  bool quiet = false;
  std::string json;
  std::string csv;
  std::string out;
};

/// The exit code.
int run_study(const StudyCommand& command);

}  // namespace moivre
