// SPDX-License-Identifier: MIT
// From an effort to the numbers of the endgame.
#include "effort.h"

#include <algorithm>

namespace moivre {
namespace {

// The ends of fewer paths are found at once: a bound costs more.
constexpr std::uint64_t kManyPaths = 32;
// Where each step halves the rest of the way at least, so many lead from the creeping radius to
// double's last digits.
constexpr int kStepsToRegularEnd = 32;
// Where no bound is met, this share of the steps is what slow paths lose.
constexpr std::uint64_t kShareOfSteps = 8;

/// A proof tells more of an end than its condition does. But it is one of the file to the letter:
/// where the file's digits are not exact they must determine the end as well as two points have to
/// agree.
double condition_of_proved_ends(const Setting& setting) {
  const EndParameters& ends = setting.endgame.ends;
  return std::max(ends.regular_condition,
                  ends.agreement / setting.prepared.plan->last().largest_error());
}

}  // namespace

Effort first_effort(const Setting& setting) {
  return setting.prepared.plan->paths < kManyPaths ? Effort::few_steps : Effort::regular_ends;
}

EndgameOptions endgame_for(const Setting& setting, Effort effort) {
  EndgameOptions endgame = setting.endgame;
  switch (effort) {
    case Effort::regular_ends:
      endgame.only_regular = true;
      endgame.goes_straight = false;
      endgame.creeping_steps = kStepsToRegularEnd;
      endgame.ends.regular_condition = condition_of_proved_ends(setting);
      break;
    case Effort::few_steps:
      endgame.ends.maximum_steps /= kShareOfSteps;
      break;
    case Effort::all_steps:
      break;
  }
  return endgame;
}

}  // namespace moivre
