// SPDX-License-Identifier: MIT
// Which motions are refused before any work? Every broken rule, as a sentence.
#include <cmath>

#include "moivre/expression/refusal.h"
#include "moivre/motion/motion.h"

namespace moivre {
namespace {

// More samples than a plot shows, or a table is read by, only cost memory.
constexpr int kMostSamples = 1000000;

}  // namespace

std::vector<std::string> validate(const MotionOptions& options) {
  std::vector<std::string> broken;
  if (!std::isfinite(options.from) || !std::isfinite(options.to) || !(options.to > options.from)) {
    broken.emplace_back("`to` must be later than `from`, both finite");
  }
  if (options.steps < 1 || options.steps > kMostSamples) {
    broken.emplace_back("`steps` must lie between 1 and a million");
  }
  if (options.checkpoints < 0 || options.checkpoints > kMostSamples) {
    broken.emplace_back("`checkpoints` must lie between 0 and a million");
  }
  return broken;
}

void require_workable(const Mechanism& mechanism, const MotionOptions& options) {
  require_unbroken(validate(options));
  for (const double time : {options.from, options.to}) require_drivers(mechanism, time);
}

}  // namespace moivre
