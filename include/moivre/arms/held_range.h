// SPDX-License-Identifier: MIT
// Which closures has an arm at one pose, with one of its joints held at many values? For arms of
// more joints than a pose takes.
//
// Values: radians of a turn, metres of a slide; `count` of them at equal distances, from and to
// included; one is `from`.
// Each value makes an arm of its own, of which all is solved: what is special at one of them is
// special there alone.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "moivre/arms/arm_closures.h"

namespace moivre {

struct HeldRange {
  std::string joint;
  double from = 0, to = 0;
  std::size_t count = 1;
};

/// Throws InvalidInput where an end is not finite, or there is no value or more than a million.
std::vector<double> values_of(const HeldRange& range);

/// The arm with the joint held at each value. Throws std::invalid_argument as make_arm() does, and
/// where `choice` holds the joint too.
std::vector<Arm> arms_along(const Robot& robot, const ArmChoice& choice, const HeldRange& range);

/// As find_arm_closures() of each arm, at one pose, in the order of the arms. A set `stop` ends it
/// with those that are finished.
std::vector<ArmResult> find_closures_of_each(
    const std::vector<Arm>& arms, const TypedPose& pose, const Tracker& tracker,
    const SolveOptions& options = {}, const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
