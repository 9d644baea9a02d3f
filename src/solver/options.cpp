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
  if (options.care < 0) broken.push_back("care must be 0 or more");
  if (options.maximum_care < 0) broken.push_back("maximum_care must be 0 or more");
  if (options.endgame.samples < 4 || options.endgame.samples % 2 != 0) {
    broken.push_back("endgame.samples must be even and at least 4");
  }
  if (options.endgame.maximum_winding < 1) {
    broken.push_back("endgame.maximum_winding must be at least 1");
  }
  return broken;
}

}  // namespace moivre
