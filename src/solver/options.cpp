// SPDX-License-Identifier: MIT
// Which options does a solve refuse? Every broken rule, as a sentence.
#include "moivre/solver/solve.h"

namespace moivre {
namespace {

// More threads than any machine has cores only cost memory.
constexpr int kMostThreads = 1024;

}  // namespace

std::vector<std::string> validate(const SolveOptions& options) {
  std::vector<std::string> broken;
  if (options.threads < 0 || options.threads > kMostThreads) {
    broken.push_back("threads must lie between 0 (all cores) and " + std::to_string(kMostThreads));
  }
  if (options.tolerance_level < 0) broken.push_back("tolerance_level must be 0 or more");
  if (options.maximum_tolerance_level < 0)
    broken.push_back("maximum_tolerance_level must be 0 or more");
  for (const std::string& rule : validate(options.endgame.ends)) {
    broken.push_back("endgame.ends." + rule);
  }
  return broken;
}

}  // namespace moivre
