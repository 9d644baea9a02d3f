// SPDX-License-Identifier: MIT
// Which closures does the way to every pose begin at? Those of a regular pose, solved once for the
// arm.
//
// An arm of six joints stands for the arm (six_joints.h). Where joints are held that move on curved
// sets there are several, each with other values of these: a curved set may have no posture for
// one.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "group_formula.h"
#include "regular_pose.h"
#include "six_joints.h"

namespace moivre {

inline constexpr std::size_t kSixJoints = 6;

/// An arm of six joints that stands for the arm, and its closures at a regular pose.
struct ArmBeginning {
  SixJoints six;
  RegularPose regular;
  std::optional<GroupFormula> formula;  ///< where the cut is at a wrist or parallel axes
};

struct PreparedArm {
  const Arm& arm;
  std::uint64_t seed = 0;
  SolveOptions options;
  std::vector<ArmBeginning>
      beginnings;  ///< one; more where joints are held that move on curved sets
  bool is_always_moving = false;
  bool is_complete = false;
  ArmResult account;  ///< of the solves at regular poses: what every pose's result begins with
};

/// Stopped: incomplete.
PreparedArm prepare(const Arm& arm, const Tracker& tracker, const SolveOptions& options,
                    const std::atomic<bool>& stop);

}  // namespace moivre
