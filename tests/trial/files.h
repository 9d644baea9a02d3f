// SPDX-License-Identifier: MIT
// What does the program answer to a file of the trial? Its exit code, text and JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

namespace moivre::test {

inline std::string trial(const std::string& name) {
  return std::string(MOIVRE_SOURCE_DIR) + "/tests/trial/files/" + name + ".toml";
}

/// `moivre COMMAND FILE options...`
inline Outcome tried(const std::string& command, const std::string& name,
                     const std::vector<std::string>& options = {}) {
  std::vector<std::string> words{command, trial(name)};
  words.insert(words.end(), options.begin(), options.end());
  return Scene().run(words);
}

struct Answer {
  int exit_code = -1;
  nlohmann::json json;
};

inline Answer answered(const std::string& command, const std::string& name,
                       std::vector<std::string> options = {}) {
  options.insert(options.end(), {"--quiet", "--json", "-"});
  const Outcome outcome = tried(command, name, options);
  return {outcome.exit_code, nlohmann::json::parse(outcome.out)};
}

}  // namespace moivre::test
